"""Faults around people: a stop, a button, a tripped drive, a holder that is gone, a closed browser."""

from onika.engine.news import Abort
from onika.host.foresight.fault_kind import EVERYBODY, FaultKind
from onika.host.foresight.outlook import LOOP_MS, STEP_MS, Outlook
from onika.host.foresight.process_faults import vanish
from onika.host.foresight.remedies import after_run, after_task
from onika.host.foresight.situation import Situation
from onika.host.run.departure import after_departure
from onika.host.sessions.dependents import runs_of, subsystems_of
from onika.link.link_terms import LOCAL
from onika.model.lifecycle import State
from onika.ring.device import DriveState
from onika.ring.drive import DriveInput
from onika.wire.foresight import Effect
from onika.words.reason import Reason

_MS = 1e-6


def _stop(outlook: Outlook, _subject: str) -> None:
    """Straight to the devices and every unit; then every run ends, and nothing comes on before a reset (law 27)."""
    text = Reason.of("foresight.stopped", ms=LOOP_MS)
    outlook.note(Effect(LOOP_MS, "runtime", "", "MOVES", "STOPPED", text, "Stopped"))
    for device in outlook.drives:
        outlook.drive(device, DriveInput.STOP, LOOP_MS)
    for address in outlook.on_in({facts.subsystem for facts in outlook.situation.tasks.values()}):
        outlook.turn_off(address, LOOP_MS)
    for number in range(len(outlook.situation.runs)):
        outlook.abort(number, text, LOOP_MS)


def _after_stop(outlook: Outlook, subject: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.do_reset"), *after_run(outlook, subject))


def _claimed(situation: Situation) -> tuple[str, ...]:
    """The devices that tasks command."""
    devices = {facts.device for facts in situation.tasks.values() if facts.state is not State.KILLED}
    return tuple(sorted(devices & set(situation.modes)))


def _press(outlook: Outlook, device: str) -> None:
    _strike(outlook, device, DriveInput.PRESS)


def _trip(outlook: Outlook, device: str) -> None:
    _strike(outlook, device, DriveInput.UNSOUND)


def _strike(outlook: Outlook, device: str, drive_input: DriveInput) -> None:
    """The drive holds at once; the task that commands it gives up where its module looks at the drive."""
    outlook.drive(device, drive_input, 0.0)
    shown, address = outlook.drives[device].shown, outlook.claims.get(device)
    if address is None or outlook.states[address] is not State.ON:
        return
    facts = outlook.situation.tasks[address]
    if shown in facts.looks_at:
        cause = _pressed(device) if shown is DriveState.PRESSED else _tripped(device)
        outlook.fail(address, cause, STEP_MS + facts.period_ms)


def _pressed(device: str) -> Reason:
    return Reason.of("foresight.button", device=device)


def _tripped(device: str) -> Reason:
    return Reason.of("foresight.drive", device=device)


def _overlooked(outlook: Outlook, device: str) -> tuple[Reason, ...]:
    """A task that does not look at its drive goes on, and its commands are not heard."""
    address = outlook.claims.get(device)
    drive = outlook.drives[device].shown
    if address is None or outlook.states[address] is not State.ON or drive is DriveState.DRIVEN:
        return ()
    return (Reason.of("foresight.overlooked", task="/".join(address), device=device),)


def _after_press(outlook: Outlook, device: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.do_let_go", device=device), *after_task(outlook, device))


def _after_trip(outlook: Outlook, device: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.do_clear_drive", device=device), *after_task(outlook, device))


# Sessions


def _sessions(situation: Situation) -> tuple[str, ...]:
    """Those on whom something depends."""
    holders = [*situation.holders.values(), *(run.session for run in situation.runs)]
    return tuple(sorted({session for session in holders if session}))


def _elsewhere(situation: Situation) -> tuple[str, ...]:
    """Those that can be silent; the program that launched the runtime cannot, but it can end."""
    launchers = {name for name, session in situation.sessions.items() if session.is_launcher}
    return tuple(name for name in _sessions(situation) if name not in launchers)


def _fall_silent(outlook: Outlook, session: str) -> None:
    """Its lease runs out; without one it is missed when the link gives it up."""
    situation = outlook.situation
    facts = situation.sessions.get(session)
    lease_ms = 0.0 if facts is None else facts.lease_ms
    at_ms = (lease_ms or LOCAL.lost_ns * _MS) + 2 * LOOP_MS
    cause = Reason.of("foresight.holder", session=session)
    left = runs_of(session, situation.runs, is_silent=bool(lease_ms))
    for number, run in enumerate(situation.runs):
        if run in left:
            for message in after_departure(run.on_loss, run.subsystems, cause):
                news = Abort(cause) if isinstance(message, Abort) else message
                outlook.tell_engine(number, news, at_ms)
            for name in run.subsystems:
                _let_go(outlook, name, session, at_ms)
    for name in subsystems_of(session, situation.holders):
        for address in outlook.on_in([name]):
            outlook.turn_off(address, at_ms)
        _let_go(outlook, name, session, at_ms)


def _let_go(outlook: Outlook, subsystem: str, session: str, at_ms: float) -> None:
    text = Reason.of("foresight.nobody_holds", subsystem=subsystem, ms=at_ms)
    outlook.note(Effect(at_ms, "subsystem", subsystem, session, "", text, "Held"))


def _end_environment(outlook: Outlook, session: str) -> None:
    """With the program that launched it a runtime ends; anybody else is missed as one who is silent."""
    facts = outlook.situation.sessions.get(session)
    if facts is not None and facts.is_launcher:
        vanish(outlook, LOOP_MS)
    else:
        _fall_silent(outlook, session)


def _take_over(outlook: Outlook, session: str) -> tuple[Reason, ...]:
    facts = outlook.situation.sessions.get(session)
    if facts is not None and facts.is_launcher:
        return (Reason.of("foresight.do_start_runtime"),)
    return (Reason.of("foresight.do_take"), *after_run(outlook, session))


def _close_browser(_outlook: Outlook, _subject: str) -> None:
    """What holds and is heard is the environment, not the browsers that look at it."""


def _page_notes(_outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.page_notes"),)


STOP = FaultKind("stop", lambda _: EVERYBODY, lambda _: Reason.of("foresight.stop"), _stop, _after_stop)
BUTTON = FaultKind("button", _claimed, _pressed, _press, _after_press, _overlooked)
DRIVE = FaultKind("drive", _claimed, _tripped, _trip, _after_trip, _overlooked)
LINK = FaultKind(
    "link", _elsewhere, lambda session: Reason.of("foresight.link", session=session), _fall_silent, _take_over
)
HOLDER = FaultKind(
    "holder", _elsewhere, lambda name: Reason.of("foresight.holder", session=name), _fall_silent, _take_over
)
ENVIRONMENT = FaultKind(
    "environment",
    _sessions,
    lambda session: Reason.of("foresight.environment", session=session),
    _end_environment,
    _take_over,
)
BROWSER = FaultKind(
    "browser", lambda _: EVERYBODY, lambda _: Reason.of("foresight.browser"), _close_browser, notes=_page_notes
)
