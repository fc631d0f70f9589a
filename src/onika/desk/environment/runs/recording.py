"""Recording a run: that it can be written is made sure of before anything moves, its size is told after it (X05)."""

import shutil
import tempfile
from pathlib import Path

import msgspec

from onika.desk.environment.file.recordings_folder import recording_path
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.model import Model
from onika.wire import act
from onika.wire.view import Remedy

LEAST_BYTES = 50_000_000
"""So much room must be there: some minutes of a robot with all that is measured at it."""

_MEGA = 1_000_000


def place(model: Model, command: act.Run, name: str, outside: Surroundings) -> Path | No | None:
    """The file of a run that is to be recorded; a no where none can be made, None where none is wanted."""
    if not command.is_recorded:
        return None
    if model.runtime.address:
        where = f"the runtime at {model.runtime.address} was started by somebody else"
        return without(f"{where}: it records runs only for the program that launched it", command)
    if outside.state is None:
        return without("there is no folder for recordings in this session", command)
    path = recording_path(outside.state, name, outside.calendar())
    wrong = _unwritable(path.parent)
    return without(wrong, command) if wrong else path


def without(why: str, command: act.Run) -> No:
    """It cannot be recorded; the user may run it all the same."""
    remedy = Remedy("Run without recording", msgspec.structs.replace(command, is_recorded=False))
    return No(f"the run cannot be recorded: {why}", (remedy,))


def measured(run: Run) -> Run:
    """A run that is over, with the size of its recording."""
    if not run.view.recording:
        return run
    try:
        size = Path(run.view.recording).stat().st_size
    except OSError:
        size = 0  # somebody has moved it away already
    return run.shown(recorded_bytes=size)


def _unwritable(folder: Path) -> str:
    """Why nothing can be written there; empty: it can."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            free = shutil.disk_usage(folder).free
    except OSError as wrong:
        return f"nothing can be written in {folder}: {wrong.strerror or wrong}"
    if free < LEAST_BYTES:
        return f"{folder} has room for {free // _MEGA} MB, and {LEAST_BYTES // _MEGA} MB are wanted at least"
    return ""
