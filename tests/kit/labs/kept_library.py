"""A site that keeps its library: changed files come in, and it is published anew.

with KeptLibrary(tmp_path) as kept:
    kept.change("ann", ("module/wink.rmod", before, after))
"""

from datetime import timedelta
from hashlib import sha256
from pathlib import Path
from typing import Self

from msgspec import json

from kit.labs.library_server import LibraryServer
from kit.labs.library_site import TODAY, LibrarySite
from onika.agent.change_check import ChangeCheck
from onika.agent.launches import Guest
from onika.agent.library_keeper import LibraryKeeper
from onika.link.caller import Role
from onika.store.audit_trail import AuditTrail
from onika.store.remote.publication import Publisher
from onika.store.site import open_site
from onika.wire.library_change import ChangeAnswer, ChangedFile, LibraryChange

MINUTE_NS = 60 * 10**9


class KeptLibrary:
    """Its server takes changes from one user, a programmer."""

    def __init__(self, folder: Path, site: LibrarySite | None = None) -> None:
        self.site = site or LibrarySite(folder)
        self.publisher = Publisher(self.site.base, self.site.folder, self.site.key, self.site.name)
        types, _ = open_site([], {}, folder).syntax()
        assert types is not None
        self.trail = AuditTrail(folder / "trail" / "library.log")
        self.now_ns, self.today = 0, TODAY + timedelta(days=1)
        self.keeper = LibraryKeeper(
            self.publisher, ChangeCheck(types), self.trail, lambda: self.today, lambda: self.now_ns
        )
        self.keeper.begin()
        self.server = LibraryServer(self.site.folder)
        self.server.takes = self.taken

    def __enter__(self) -> Self:
        self.server.__enter__()
        return self

    def __exit__(self, *_: object) -> None:
        self.server.__exit__()
        self.trail.close()

    def taken(self, body: bytes) -> bytes:
        """What the site answers to what is sent."""
        self.now_ns += MINUTE_NS
        return json.encode(self.keeper.take(json.decode(body, type=LibraryChange), Guest("ann", Role.PROGRAMMER)))

    def change(
        self, *files: tuple[str, str | None, str | bytes], role: Role = Role.PROGRAMMER, user: str = "ann"
    ) -> ChangeAnswer:
        """The site's answer to files: path, the text they were begun with, the text they are to be."""
        changed = tuple(
            ChangedFile(path, hash_of(before), after if isinstance(after, bytes) else after.encode())
            for path, before, after in files
        )
        return self.keeper.take(LibraryChange(self.site.name, changed, "lamp off"), Guest(user, role))

    def text(self, path: str) -> str:
        """What a file of the site holds."""
        return (self.site.base / path).read_text()


def hash_of(text: str | None) -> str:
    """The SHA-256 of a text; empty: there is none."""
    return "" if text is None else sha256(text.encode()).hexdigest()
