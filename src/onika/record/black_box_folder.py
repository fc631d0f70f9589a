"""Where black boxes lie: recordings of the last seconds of runs that ended badly, few and bounded (requirement X05)."""

import fcntl
import os
import re
import tempfile
from collections.abc import Callable, Mapping
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import BinaryIO

KEPT = 20
"""Black boxes that are kept; with one more the oldest goes."""
MOST_BYTES = 256 * 2**20
"""What all of them may take together; the newest is kept in any case."""
ENDING = ".mcap"
_UNFINISHED = ".unfinished"
_STRANGE = re.compile(r"[^A-Za-z0-9_.-]+", re.ASCII)
_LONGEST = 60


def black_box_folder(environment: Mapping[str, str]) -> Path:
    """The folder in the user's state directory, as the XDG says it; it need not be there yet."""
    state = environment.get("XDG_STATE_HOME", "")
    home = Path(state) if state.startswith("/") else Path(environment.get("HOME", "/")) / ".local" / "state"
    return black_boxes_in(home / "onika")


def black_boxes_in(state: Path) -> Path:
    """The folder within the state directory of Onika."""
    return state / "black-boxes"


def black_box_path(folder: Path, application: str, began: datetime, process: int, number: int) -> Path:
    """The file of the run with this number of a runtime: `NAME-20261121-231500-PROCESS-NUMBER.mcap`.

    An application may be called as somebody elsewhere likes; what no file should be called is left out of the name.
    """
    name = _STRANGE.sub("_", application)[:_LONGEST].lstrip(".") or "run"
    return folder / f"{name}-{began:%Y%m%d-%H%M%S}-{process}-{number}{ENDING}"


def fault_path(path: Path, fault: int) -> Path:
    """The file of the fault with this number: `…-NUMBER.FAULT.mcap`, beside that of the run's end (`path`)."""
    return path.with_name(f"{path.stem}.{fault}{ENDING}")


def black_box_of(folder: Path, process: int) -> Path | None:
    """The newest black box of the end of a run that the runtime of this process id has left."""
    ends = (path for path in black_boxes(folder) if _is_end_of(path, process))
    return next(ends, None)


def is_being_written(folder: Path, process: int) -> bool:
    """Whether somebody writes a black box of the runtime of this process id just now."""
    return any(folder.glob(f"*-{process}-*{ENDING}*{_UNFINISHED}"))


def _is_end_of(path: Path, process: int) -> bool:
    """Whether it was written at the end of a run of this process, not at a fault before."""
    _, _, numbers = path.stem.rpartition(f"-{process}-")
    return numbers.isdecimal() and path.stem.endswith(f"-{process}-{numbers}")


def black_boxes(folder: Path) -> list[Path]:
    """All that are there, newest first."""
    dated = []
    for path in folder.glob(f"*{ENDING}"):
        with suppress(OSError):  # somebody else has thrown it away
            dated.append((path.stat().st_mtime_ns, path))
    return [path for _, path in sorted(dated, reverse=True)]


def write_black_box(path: Path, write: Callable[[BinaryIO], None]) -> None:
    """Write a black box whole or not at all, for the user's eyes only; then the oldest go. Raises OSError."""
    for folder in (path.parent.parent, path.parent):  # each of them for the user only
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    descriptor, unfinished = tempfile.mkstemp(_UNFINISHED, path.name, path.parent)  # of mode 0600
    try:
        with os.fdopen(descriptor, "wb") as stream:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)  # until it is closed; killed meanwhile, nobody holds it
            write(stream)
        Path(unfinished).replace(path)
    except BaseException:
        Path(unfinished).unlink(missing_ok=True)
        raise
    rotate(path.parent)


def clear_unfinished(folder: Path) -> None:
    """Throw away what somebody began to write who was killed meanwhile; whatever is being written stays."""
    for path in folder.glob(f"*{_UNFINISHED}"):
        with suppress(OSError), path.open("rb") as stream:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
            path.unlink()


def rotate(folder: Path, kept: int = KEPT, most_bytes: int = MOST_BYTES, longest_s: float = 3600.0) -> None:
    """Throw away the oldest beyond `kept` and `most_bytes`, and what was left unfinished `longest_s` ago."""
    size = 0
    boxes = black_boxes(folder)
    newest_at = boxes[0].stat().st_mtime if boxes else 0.0
    for number, path in enumerate(boxes):
        with suppress(OSError):
            size += path.stat().st_size
            if number and (number >= kept or size > most_bytes):
                path.unlink()
    for path in folder.glob(f"*{_UNFINISHED}"):
        with suppress(OSError):
            if path.stat().st_mtime < newest_at - longest_s:
                path.unlink()
