"""The state directory of a user, in which Onika keeps what is nobody else's: token, diary, audit trail, recordings."""

from collections.abc import Iterator, Mapping
from pathlib import Path

from onika.files.state.access import ANYTHING, WRITING, Access

_SECRET = ("token", "console_history", "staying", "staying.log", "bookings", "sites", "page-users", "address-book")
_SECRET_FOLDERS = ("audit", "diary", "black-boxes", "library-tokens", "certificates")
_FOLDERS = ("recordings", "recovery", "replaced", "meshes", "browser")
_MOST = 1000
"""Files of a folder that are looked at."""


def state_directory(environment: Mapping[str, str]) -> Path:
    """Where it is, as the XDG says it; it need not be there yet."""
    state = environment.get("XDG_STATE_HOME", "")
    home = Path(state) if state.startswith("/") else Path(environment.get("HOME") or Path.home()) / ".local" / "state"
    return home / "onika"


def make_own(folder: Path) -> None:
    """Make a folder with all that it lies in, each that is not there yet for its user only; raises OSError."""
    for missing in reversed([path for path in (folder, *folder.parents) if not path.is_dir()]):
        missing.mkdir(mode=0o700, exist_ok=True)


def guarded(state: Path) -> Iterator[Access]:
    """What others may neither read nor write in a state directory, the directory itself first."""
    yield Access(state, ANYTHING)
    for name in _SECRET:
        yield Access(state / name, ANYTHING)
    for name in _SECRET_FOLDERS:
        yield Access(state / name, ANYTHING)
        yield from (Access(path, ANYTHING) for path in _files(state / name))
    for name in _FOLDERS:
        yield Access(state / name, ANYTHING)
        yield from (Access(path, WRITING) for path in _files(state / name))


def _files(folder: Path) -> list[Path]:
    try:
        return sorted(folder.iterdir())[:_MOST]
    except OSError:
        return []
