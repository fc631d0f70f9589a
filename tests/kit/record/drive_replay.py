"""A replay of what drives did, through their table: whatever a recording tells of them, the table has to make (R-X24).

for complaint in complaints(drive_events(reader)):
    print(complaint)

What others see of a drive hides some of its modes: a replay knows all modes in which it may be. A drive whose causes
have no key is of another world, and not judged.
"""

from collections.abc import Iterable, Iterator
from pathlib import Path

from onika.record import topics
from onika.record.reader import UNREADABLE, Reader
from onika.ring.device import DriveState
from onika.ring.drive import SILENCE_NS, TABLE, TRIP_NS, DriveInput, DriveMode, DriveUnit
from onika.wire import event
from onika.words.reason import Reason

_INPUTS = {drive_input.value.key: drive_input for drive_input in DriveInput}
_SILENCES = {DriveInput.SILENCE: SILENCE_NS, DriveInput.LONG_SILENCE: TRIP_NS}
Modes = frozenset[DriveMode]


def drive_events(reader: Reader) -> Iterator[event.Drive]:
    """What a recording tells of drives, in its order."""
    for _, body in reader.messages(topics.EVENTS):
        message = topics.decode_happened(body).event
        if isinstance(message, event.Drive):
            yield message


def complaints(events: Iterable[event.Drive], begin: Modes = frozenset(DriveMode)) -> Iterator[str]:
    """Whatever the table would not have made of what it was told; `begin` are the modes it may begin in."""
    modes: dict[str, Modes] = {}
    for told in events:
        drive_input = _INPUTS.get(told.cause.key) if isinstance(told.cause, Reason) else None
        if drive_input is None:
            continue
        before = modes.get(told.device, begin)
        after = _after(before, drive_input, DriveState[told.state])
        if not after:
            yield f"{told.device} at {told.at_ns} ns: {told.state} by {drive_input.name} is not in the table"
        wrong = _silence(told, _SILENCES.get(drive_input))
        if wrong:
            yield f"{told.device} at {told.at_ns} ns: {drive_input.name} {wrong}"
        modes[told.device] = after or begin


def complaints_of_recordings(folder: Path) -> Iterator[str]:
    """Those of every recording below; one that cannot be read is not judged."""
    for path in sorted(folder.rglob("*.mcap")):
        try:
            told = list(drive_events(Reader(path)))
        except UNREADABLE:
            continue
        yield from (f"{path.name}: {complaint}" for complaint in complaints(told))


def _shown(mode: DriveMode) -> DriveState:
    drive = DriveUnit()
    drive.mode = mode
    return drive.shown


def _after(before: Modes, drive_input: DriveInput, state: DriveState) -> Modes:
    """The modes it may be in now: from one that looked otherwise, this input led to one that looks like this."""
    reached = set(before)
    fresh = list(before)
    while fresh:  # what happened meanwhile and did not show
        mode = fresh.pop()
        hidden = {then for then in TABLE[mode].values() if _shown(then) is _shown(mode)} - reached
        reached |= hidden
        fresh += hidden
    moved = {TABLE[mode][drive_input] for mode in reached if _shown(mode) is not state}
    return frozenset(mode for mode in moved if _shown(mode) is state)


def _silence(told: event.Drive, limit_ns: int | None) -> str:
    """What is wrong with the instant of a silence; nothing for anything else."""
    if limit_ns is None:
        return ""
    if told.at_ns - told.last_command_ns <= limit_ns:
        return f"after {told.at_ns - told.last_command_ns} ns only"
    if told.previous_step_ns - told.last_command_ns > limit_ns:
        return f"a step late: {told.previous_step_ns - told.last_command_ns} ns had passed at the step before"
    return ""
