"""A site that publishes a library, honestly or not, and the user who takes it.

site = LibrarySite(tmp_path)
site.write("module/wink.rmod", "MODULE wink …")
site.publish()
libraries = taken(tmp_path, site)
"""

import subprocess
from collections.abc import Mapping
from dataclasses import replace
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import zstandard

from onika.files import library_index
from onika.files.library_index import LibraryIndex, indexed_text
from onika.files.library_lock import LockedLibrary
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.lock_file import LockFile
from onika.store.remote.object_cache import ObjectCache
from onika.store.remote.publication import Publication, Publisher
from onika.store.remote.remote_libraries import Offer, RemoteLibraries
from onika.store.remote.signature import sign

TODAY = date(2026, 11, 24)
WINK = """MODULE      wink
DESC        {says}
INCONST     none
OUTCONST    none
INVAR       none
OUTVAR      {outputs}
TASKTYPE    periodic
FREQ        50
EOF
"""
WINK_CODE = '''"""Winks."""

from onika.module import Module, OutVar, finish


class Wink(Module):
    """Winks once."""

    trigger = True
    LAMP = OutVar("int", "-", "1: on")

    def cycle(self):
        self.LAMP = 1 - self.LAMP
        return finish()
'''


def wink(*outputs: str, says: str = "winks") -> str:
    """The file of a task that writes these."""
    return WINK.format(outputs=" ".join(outputs) or "LAMP", says=says)


def new_key(folder: Path, name: str = "key") -> Path:
    """A key pair without a pass phrase."""
    path = folder / name
    subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-C", "lab", "-f", path], check=True)
    return path


class LibrarySite:
    """Its base directory, the folder that it gives away, and its key."""

    def __init__(self, folder: Path, name: str = "wings") -> None:
        self.name = name
        self.base, self.folder = folder / name, folder / f"{name}_public"
        self.base.mkdir()
        self.key = new_key(folder, f"{name}_key")
        self.write("module/wink.rmod", wink())
        self.write("module/wink.py", WINK_CODE)

    def write(self, path: str, content: str) -> None:
        """A file of the base directory."""
        target = self.base / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(content)

    def publish(self, today: date = TODAY, **options: Any) -> Publication:
        """As `onika library publish` does."""
        publication = Publisher(self.base, self.folder, self.key, self.name).publish(today, **options)
        assert isinstance(publication, Publication), publication
        return publication

    def index(self, files: Mapping[str, str] | None = None, **fields: Any) -> LibraryIndex:
        """An index that nobody would publish by mistake: these texts, these fields."""
        texts = {"module/wink.rmod": wink()} if files is None else files
        indexed = {path: indexed_text(path, content.encode()) for path, content in texts.items()}
        index = LibraryIndex(self.name, 1, TODAY, TODAY + timedelta(days=30), files=indexed)
        return replace(index, **fields)

    def signed(self, index: LibraryIndex, key: Path | None = None) -> bytes:
        """An index with its signature."""
        content = sign(zstandard.compress(library_index.write(index)), key or self.key)
        assert isinstance(content, bytes), content
        return content

    def give(self, content: bytes) -> None:
        """Put signed bytes where the index is."""
        self.folder.mkdir(exist_ok=True)
        (self.folder / "library").write_bytes(content)


def libraries_of(folder: Path) -> RemoteLibraries:
    """The libraries of a user who has none yet."""
    base = folder / "home" / "onika"
    base.mkdir(parents=True, exist_ok=True)
    return RemoteLibraries(LockFile(base), LibraryAccess(ObjectCache(folder / "cache" / "onika"), None))


def taken(folder: Path, site: LibrarySite, address: str = "") -> RemoteLibraries:
    """A user who trusts the site and uses its library."""
    libraries = libraries_of(folder)
    offer = libraries.offer(address or str(site.folder), TODAY)
    assert isinstance(offer, Offer), offer
    added = libraries.add(offer, "2026-11-24 ann")
    assert isinstance(added, LockedLibrary), added
    return libraries
