"""Console commands that let time pass: `advance`, and `wait` for a condition (requirement A16, law 15)."""

import re
from collections.abc import Callable

from onika.desk.console.inspection import value
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.steering_lines import where
from onika.desk.console.task_lines import missing, positive
from onika.model.lifecycle import State
from onika.wire import live, request
from onika.words.condition import Condition
from onika.words.reason import Reason

Words = tuple[str, ...]
_WITHIN = re.compile(r"(.*?)\s+within\s+(\S+)\s*\Z")
_USUAL_S = 60.0
_SLICE_S = 0.25
"""Of virtual time: between two slices events are told and Ctrl-C is heard."""
_FLOW_STATES = ("paused", "waiting", "stopped", "running", "done")
_STEP_S = 0.02
"""How often a condition is looked at."""


def advance(session: ConsoleSession, words: Words) -> Faults:
    """In virtual time: let so many seconds pass."""
    seconds = positive(words[0])
    if seconds is None:
        return session.no(Reason.of("console.seconds", word=words[0]))
    if not session.standing().is_virtual:
        return session.no(Reason.of("console.wall_time"))
    return _advance(session, seconds)


def wait(session: ConsoleSession, words: Words) -> Faults:
    """Wait for seconds of the runtime's time, or until a condition holds."""
    text = words[0]
    seconds = positive(text)
    if seconds is not None:
        return pass_time(session, seconds)
    match = _WITHIN.match(text)
    condition, limit = (match[1], positive(match[2])) if match else (text, _USUAL_S)
    if limit is None:
        return session.no(Reason.of("console.within_seconds", text=text))
    if condition == "run":
        return ended(session, None if match is None else limit)
    parts = condition.split()
    if len(parts) == 2 and parts[1] in _FLOW_STATES:
        return _flow(session, parts[0], parts[1], limit)
    if len(parts) == 2 and parts[1].upper() in State.__members__:
        return _state(session, parts[0], parts[1].upper(), limit)
    try:
        expectation = Condition.parse(condition)
    except ValueError:
        return session.no(Reason.of("console.wait_usage", text=text))
    return _variable(session, expectation, limit)


def pass_time(session: ConsoleSession, seconds: float) -> Faults:
    """Let so many seconds of the runtime's time pass."""
    if session.standing().is_virtual:
        return _advance(session, seconds)
    return _sleep(session, seconds)


def ended(session: ConsoleSession, within_s: float | None = None) -> Faults:
    """Wait for the end of the run; a fault where it is not completed."""
    if not session.running and session.result is None:
        return session.no(Reason.of("console.no_run_to_wait_for"))
    faults = until_asked(session, within_s)
    if faults or session.running:
        return faults or _asked(session)
    result = session.result
    if result is None or result.completed:
        return ()
    return session.no(Reason.of("console.run_aborted", cause=result.cause), Reason.of("console.robot_holds"))


def until_asked(session: ConsoleSession, within_s: float | None = None) -> Faults:
    """Wait until the run is over or one of the tasks asks; a fault where neither is so within the seconds."""
    limit = float("inf") if within_s is None else within_s
    name = session.running
    return session.until(
        lambda: not session.running or bool(session.questions), Reason.of("console.end_of", name=name), limit
    )


def _state(session: ConsoleSession, address: str, state: str, limit: float) -> Faults:
    subsystem, name = session.address(address)
    if state != State.KILLED.value:
        faults = missing(session, subsystem, (name,))
        if faults:
            return faults

    def now() -> str:
        task = session.tasks(subsystem).get(name)
        return State.KILLED.value if task is None else task.state

    return _until(session, lambda: now() == state, limit, f"{address} {state}", now)


def _flow(session: ConsoleSession, name: str, state: str, limit: float) -> Faults:
    def now() -> str:
        return next((position.state for position in where(session) if position.subsystem == name), "")

    if not now():
        return session.no(Reason.of("console.no_flow", name=name))
    gone = Reason.of("console.flow_gone")
    return _until(session, lambda: now() == state, limit, f"{name} {state}", lambda: now() or gone)


def _variable(session: ConsoleSession, expectation: Condition, limit: float) -> Faults:
    subsystem, name = session.address(expectation.address)
    _, faults = value(session, subsystem, name)
    if faults:
        return faults
    seen: dict[str, object] = {}

    def holds() -> bool:
        seen[expectation.address] = value(session, subsystem, name)[0]
        return expectation.holds(seen)

    return _until(session, holds, limit, expectation.text, lambda: str(expectation.value_of(seen)))


def _until(
    session: ConsoleSession,
    reached: Callable[[], bool],
    limit: float,
    expected: str,
    reality: Callable[[], Reason | str],
) -> Faults:
    """Let time pass, the runtime's own, until something is so."""
    virtual = session.standing().is_virtual
    until_s = _now(session, virtual) + limit
    while not reached():
        if session.is_interrupted():
            return session.interrupt()
        if _now(session, virtual) >= until_s - 1e-9:
            late = Reason.of("console.not_within", expected=expected, limit=limit, reality=reality())
            return session.no(late, Reason.of("console.line_given_up"))
        if not virtual:
            session.hear(_STEP_S)
            continue
        faults = _advance(session, _STEP_S)
        if faults:
            return faults
    return ()


def _now(session: ConsoleSession, virtual: bool) -> float:
    """The time that counts, in s: the runtime's own where it can be stopped and hurried."""
    if virtual:
        return session.look_again().now_s
    return session.clock()


def _sleep(session: ConsoleSession, seconds: float) -> Faults:
    until_s = session.clock() + seconds
    while (rest := until_s - session.clock()) > 0:
        if session.is_interrupted():
            return session.interrupt()
        session.hear(min(rest, 0.05))
    return ()


def _advance(session: ConsoleSession, seconds: float) -> Faults:
    """In slices on a grid of their own, so that the sum is the number that was asked for."""
    count = max(1, round(seconds / _SLICE_S))
    for _ in range(count):
        if session.is_interrupted():
            return session.interrupt()
        if session.questions:
            return _asked(session)
        answer = session.ask(live.Advance(seconds / count))
        session.hear()
        if isinstance(answer, request.Refused):
            return session.no(Reason.of("console.clock_refused", reason=answer.reason))
    return ()


def _asked(session: ConsoleSession) -> Faults:
    asking = tuple("/".join(key) for key in session.questions)
    return session.no(Reason.of("console.tasks_ask", asking=asking))
