"""Where the recordings of an environment lie."""

from datetime import datetime
from pathlib import Path

ENDING = ".mcap"


def recordings_folder(state: Path) -> Path:
    """The folder of all of them; it need not be there yet."""
    return state / "recordings"


def recording_path(state: Path, name: str, calendar_s: float) -> Path:
    """The file of a run of application `name` that begins now: `NAME-20261121-231500.mcap`, never one that is there."""
    began = datetime.fromtimestamp(calendar_s).astimezone()
    stem = f"{name}-{began:%Y%m%d-%H%M%S}"
    path, number = recordings_folder(state) / f"{stem}{ENDING}", 1
    while path.exists():
        number += 1
        path = recordings_folder(state) / f"{stem}-{number}{ENDING}"
    return path
