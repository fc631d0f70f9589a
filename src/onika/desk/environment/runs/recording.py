"""Recording a run: that it can be written is made sure of before anything moves, its size is told after it (X05)."""

import shutil
import tempfile
from pathlib import Path

import msgspec

from onika.desk.environment.file.recordings_folder import recording_path
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.files.state.state_directory import make_own
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import NOTHING, Argument, Reason
from onika.words.system_error import system_reason

LEAST_BYTES = 50_000_000
"""So much room must be there: some minutes of a robot with all that is measured at it."""

_MEGA = 1_000_000


def place(model: Model, command: act.Run, name: str, outside: Services, *, is_apart: bool) -> Path | No | None:
    """The file of a run that is to be recorded; a no where none can be made, None where none is wanted.

    One at several stations is written here, wherever these are.
    """
    if not command.is_recorded:
        return None
    if model.runtime.address and not is_apart:
        return without(Reason.of("run.record_not_ours", address=model.runtime.address), command)
    if outside.state is None:
        return without(Reason.of("run.record_no_folder"), command)
    path = recording_path(outside.state, name, outside.calendar())
    wrong = unwritable(path.parent)
    return without(wrong, command) if wrong else path


def without(why: Argument, command: act.Run) -> No:
    """It cannot be recorded; the user may run it all the same."""
    remedy = Remedy(Reason.of("run.without_recording"), msgspec.structs.replace(command, is_recorded=False))
    return No(Reason.of("run.record_not", why=why), (remedy,))


def unwritable(folder: Path) -> Reason:
    """Why nothing can be written there; nothing: it can."""
    try:
        make_own(folder)
        with tempfile.TemporaryFile(dir=folder):
            free = shutil.disk_usage(folder).free
    except OSError as wrong:
        return Reason.of("run.record_unwritable", folder=str(folder), why=system_reason(wrong))
    if free < LEAST_BYTES:
        free_mb, wanted_mb = free // _MEGA, LEAST_BYTES // _MEGA
        return Reason.of("run.record_no_room", folder=str(folder), free=free_mb, wanted=wanted_mb)
    return NOTHING
