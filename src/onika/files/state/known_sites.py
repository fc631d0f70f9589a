"""The sites that a user has come to: by what each is known again, so that two of one name are told apart (F06)."""

import contextlib
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

from msgspec import DecodeError, Struct, ValidationError, json

from onika.files.state.state_directory import make_own, state_directory

_LARGEST = 1 << 20


class KnownSite(Struct, frozen=True):
    """By what a site is known again, and where it was when it was met last."""

    identity: str
    place: str


_decoder = json.Decoder(dict[str, KnownSite])


def known_sites_path(environment: Mapping[str, str] = os.environ) -> Path:
    """Where they are kept."""
    return state_directory(environment) / "sites"


class KnownSites:
    """The sites in a file, by name; raises OSError where it cannot be written."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def all(self) -> dict[str, KnownSite]:
        """Every site by its name; a file that cannot be read knows none."""
        try:
            with self._path.open("rb") as file:
                return _decoder.decode(file.read(_LARGEST))
        except (OSError, DecodeError, ValidationError):
            return {}

    def meet(self, name: str, identity: str, place: str) -> KnownSite | None:
        """The other site that has this name, if there is one; else this one is known from now on."""
        sites = self.all()
        former = sites.get(name)
        if former is not None and former.identity != identity:
            return former
        if former is None or former.place != place:
            self._keep({**sites, name: KnownSite(identity, place)})
        return None

    def forget(self, name: str) -> bool:
        """Know a name no more; whether it was known."""
        sites = self.all()
        if sites.pop(name, None) is None:
            return False
        self._keep(sites)
        return True

    def _keep(self, sites: Mapping[str, KnownSite]) -> None:
        """Whole or not at all."""
        make_own(self._path.parent)
        descriptor, draft = tempfile.mkstemp(dir=self._path.parent, prefix=".sites.")
        try:
            with os.fdopen(descriptor, "wb") as file:
                file.write(json.encode(sites) + b"\n")
            Path(draft).replace(self._path)
        except BaseException:
            with contextlib.suppress(OSError):
                Path(draft).unlink()
            raise
