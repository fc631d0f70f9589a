"""Faults of processes: a unit, a device server or the runtime's program dies or freezes; the disk is full."""

from onika.host.foresight.fault_kind import EVERYBODY, FaultKind
from onika.host.foresight.outlook import LOOP_MS, Outlook
from onika.host.foresight.remedies import DEVICES, after_run, after_task
from onika.host.foresight.situation import Situation
from onika.host.recording.recording_sink import FLUSHED_EVERY_NS
from onika.host.units.supervisor import SILENT_NS
from onika.host.units.unit_loss import dead_writers, ends_with
from onika.host.units.world_registry import split
from onika.link.link_terms import CHILD, REMOTE
from onika.model.lifecycle import State
from onika.ring.drive import DriveInput
from onika.runtime.device import SILENCE_NS
from onika.wire.foresight import Effect
from onika.words.reason import Reason

_MS = 1e-6


def freeze_unit(outlook: Outlook, unit: str) -> None:
    """Its drives count how long they hear nothing; then it is ended, as a unit that is gone."""
    ended_ms = SILENT_NS * _MS + LOOP_MS
    outlook.silence(_driven_from(outlook, unit), ended_ms)
    lose_unit(outlook, unit, ended_ms)


def lose_unit(outlook: Outlook, unit: str, at_ms: float) -> None:
    """Its writers are dead, runs that need it end, and its tasks are gone (laws 17, 30)."""
    text = _loss(unit, at_ms)
    outlook.note(Effect(at_ms, "unit", unit, "UP", "LOST", text, "Lost"))
    tasks = outlook.situation.tasks
    for device in dead_writers(unit, {device: tasks[address].unit for device, address in outlook.claims.items()}):
        outlook.drive(device, DriveInput.FENCE, at_ms)
        del outlook.claims[device]
    _end_runs(outlook, unit, at_ms)
    lost = [address for address, facts in tasks.items() if facts.unit == unit]
    fed = [starving for address in lost for starving in outlook.fed_by(address, State.KILLED)]
    for address in lost:
        outlook.kill(address, at_ms, is_heard=False)
    outlook.starve(fed, at_ms + LOOP_MS)


def vanish(outlook: Outlook, at_ms: float) -> None:
    """The runtime and all its processes are gone, whatever they did."""
    text = Reason.of("foresight.runtime_gone", ms=at_ms)
    outlook.note(Effect(at_ms, "runtime", "", "UP", "GONE", text))
    for address, facts in outlook.situation.tasks.items():
        if facts.state is not State.KILLED:
            outlook.note(_task_gone("/".join(address), facts.state, at_ms))
    outlook.vanish(list(outlook.drives), at_ms)
    for run in outlook.situation.runs:
        text = Reason.of("foresight.run_gone", application=run.application, ms=at_ms)
        outlook.note(Effect(at_ms, "run", run.application, "running", "gone", text))


def _task_gone(task: str, state: State, at_ms: float) -> Effect:
    text = Reason.of("foresight.task_turns", task=task, state=State.KILLED.value, ms=at_ms)
    return Effect(at_ms, "task", task, state.value, State.KILLED.value, text)


def _driven_from(outlook: Outlook, unit: str) -> list[str]:
    """The devices that tasks of a unit command, while they are ON."""
    tasks = outlook.situation.tasks
    return [
        device
        for device, address in outlook.claims.items()
        if tasks[address].unit == unit and outlook.states[address] is State.ON
    ]


def _end_runs(outlook: Outlook, unit: str, at_ms: float) -> None:
    for number, run in enumerate(outlook.situation.runs):
        homes = {facts.unit for facts in outlook.situation.tasks.values() if facts.subsystem in run.subsystems}
        if ends_with(unit, homes):
            outlook.abort(number, _loss(unit, at_ms), at_ms)


def _loss(unit: str, at_ms: float) -> Reason:
    """That a unit, or without a name the device server, is given up."""
    return (
        Reason.of("foresight.unit_lost", unit=unit, ms=at_ms) if unit else Reason.of("foresight.devices_lost", ms=at_ms)
    )


def _kill_unit(outlook: Outlook, unit: str) -> None:
    lose_unit(outlook, unit, LOOP_MS)


def _units(situation: Situation) -> tuple[str, ...]:
    return tuple(sorted({facts.unit for facts in situation.tasks.values() if facts.state is not State.KILLED}))


def _served_worlds(situation: Situation) -> tuple[str, ...]:
    """The worlds whose device server could be lost; where there is one only, it needs no name."""
    worlds = sorted({split(device)[0] for device in situation.modes})
    return tuple(worlds) if len(worlds) > 1 else EVERYBODY[: len(worlds)]


def _dies(world: str) -> Reason:
    if world:
        return Reason.of("foresight.devices_of", world=world)
    return Reason.of("foresight.devices")


def _freezes(world: str) -> Reason:
    if world:
        return Reason.of("foresight.devices_frozen_of", world=world)
    return Reason.of("foresight.devices_frozen")


def _kill_devices(outlook: Outlook, world: str) -> None:
    """Tasks with a device are in ERROR, every run ends; the world that it stepped is gone with it."""
    _note_devices_lost(outlook, LOOP_MS)
    _stand_still(outlook, world)
    _lose_devices(outlook, LOOP_MS)


def _freeze_devices(outlook: Outlook, world: str) -> None:
    """Hardware tasks hear nothing of their devices and fail; then the server is ended, as one that is gone."""
    cause = Reason.of("foresight.devices_frozen")
    _stand_still(outlook, world)
    for device, address in list(outlook.claims.items()):
        facts = outlook.situation.tasks[address]
        if _is_of(world, device) and outlook.states[address] is State.ON:
            outlook.fail(address, cause, SILENCE_NS * _MS + facts.period_ms)
    ended_ms = SILENT_NS * _MS + LOOP_MS
    _note_devices_lost(outlook, ended_ms)
    _lose_devices(outlook, ended_ms)


def _is_of(world: str, device: str) -> bool:
    return not world or split(device)[0] == world


def _note_devices_lost(outlook: Outlook, at_ms: float) -> None:
    outlook.note(Effect(at_ms, "unit", DEVICES, "UP", "LOST", _loss("", at_ms), "Lost"))


def _stand_still(outlook: Outlook, world: str) -> None:
    """Nobody steps a world any more."""
    gone = [device for device in outlook.drives if _is_of(world, device)]
    outlook.vanish(gone, 0.0)
    for device in gone:
        del outlook.drives[device]


def _lose_devices(outlook: Outlook, at_ms: float) -> None:
    """One server is given up: drives of other worlds hold, tasks with a device fail, every run ends."""
    for device in list(outlook.drives):
        outlook.drive(device, DriveInput.STOP, at_ms)
    for address in outlook.on_in({facts.subsystem for facts in outlook.situation.tasks.values()}):
        if outlook.situation.tasks[address].wired.device and outlook.states[address] is State.ON:
            # a run has been ended when it hears of its tasks
            outlook.fail(address, _loss("", at_ms), at_ms, is_heard=False)
    _end_runs(outlook, "", at_ms)


def _kill_runtime(outlook: Outlook, _subject: str) -> None:
    vanish(outlook, LOOP_MS)


def _freeze_runtime(_outlook: Outlook, _subject: str) -> None:
    """Units and drives go on by themselves; nobody is told anything, nobody can end it but by Ctrl-C or a kill."""


def _suspicion(_outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    here, elsewhere = (terms.suspect_ns * 1e-9 for terms in (CHILD, REMOTE))
    return (Reason.of("foresight.suspected", here_s=here, elsewhere_s=elsewhere),)


def _end_it(_outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.do_end_frozen"),)


def _restart(_outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.do_start_runtime"),)


def _recorded(situation: Situation) -> tuple[str, ...]:
    return EVERYBODY if situation.records else ()


def _fill_disk(outlook: Outlook, _subject: str) -> None:
    """The recording ends where the disk was full; the run goes on, and is told of it at once."""
    application = outlook.situation.records
    text = Reason.of("foresight.recording_cut", application=application)
    at_ms = FLUSHED_EVERY_NS * _MS + LOOP_MS
    outlook.note(Effect(at_ms, "recording", application, "WRITTEN", "CUT", text, "Warned"))


def _readable(_outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.readable"),)


UNIT_KILLED = FaultKind(
    "unit-killed", _units, lambda unit: Reason.of("foresight.unit", unit=unit), _kill_unit, after_task
)
UNIT_FROZEN = FaultKind(
    "unit-frozen", _units, lambda unit: Reason.of("foresight.unit_frozen", unit=unit), freeze_unit, after_task
)
DEVICES_KILLED = FaultKind("devices-killed", _served_worlds, _dies, _kill_devices, after_task)
DEVICES_FROZEN = FaultKind("devices-frozen", _served_worlds, _freezes, _freeze_devices, after_task)
RUNTIME_KILLED = FaultKind(
    "runtime-killed", lambda _: EVERYBODY, lambda _: Reason.of("foresight.runtime"), _kill_runtime, _restart
)
RUNTIME_FROZEN = FaultKind(
    "runtime-frozen",
    lambda _: EVERYBODY,
    lambda _: Reason.of("foresight.runtime_frozen"),
    _freeze_runtime,
    _end_it,
    _suspicion,
)
DISK = FaultKind("disk", _recorded, lambda _: Reason.of("foresight.disk"), _fill_disk, after_run, _readable)
