"""Console commands that steer a running application, whoever began it (requirements E07, E08, E13, X03)."""

from collections.abc import Callable

from onika.desk.console import task_lines
from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run import positions, steering
from onika.desk.run.steering import SteeringOrder
from onika.wire import request, steer
from onika.wire.steer import Position
from onika.words.fault import Fault
from onika.words.reason import Reason, reason_of

Words = tuple[str, ...]


def verb(name: str) -> Callable[[ConsoleSession, Words], Faults]:
    """What carries out this word of steering."""

    def carry_out(session: ConsoleSession, words: Words) -> Faults:
        flow_index = flow_index_of(session, where(session))
        if not flow_index.parts:
            return session.no(Reason.of("console.no_application_runs"))
        try:
            act = steering.act(" ".join((name, *words)), flow_index)
        except ValueError as wrong:
            return (Fault(session.place, reason_of(wrong), steering.GOES_ON),)
        if isinstance(act, SteeringOrder):
            return _order(session, act.message)
        return ()

    return carry_out


def clear(session: ConsoleSession, words: Words) -> Faults:
    """Bring a task out of ERROR; of a flow that has stopped: clear its tasks and repeat its action."""
    spots = where(session)
    stopped = [spot.subsystem for spot in spots if spot.state == "stopped"]
    if words:
        flow = flow_index_of(session, spots).flow(words[0])
        if flow:
            return _order(session, steer.Recover(flow))
        return task_lines.clear(session, words)
    if session.subsystem in stopped:
        return _order(session, steer.Recover(session.subsystem))
    if stopped and not session.tasks():
        only = stopped[0] if len(stopped) == 1 else ""
        return _order(session, steer.Recover(only))
    return task_lines.clear(session, words)


def who(session: ConsoleSession, words: Words) -> Faults:
    """Where every flow is, and who waits for whom."""
    del words
    spots = where(session)
    if not spots:
        session.say(Reason.of("console.nothing_runs"), Tone.DIM)
    else:
        session.show(positions.lines(spots, flow_index_of(session, spots), session.in_words))
    return ()


def runs(session: ConsoleSession, words: Words) -> Faults:
    """The applications that run, each with where its flows are."""
    del words
    spots = {spot.subsystem: spot for spot in where(session)}
    homes: dict[str, list[str]] = {}
    for subsystem in session.look_again().subsystems:
        if subsystem.application:
            homes.setdefault(subsystem.application, []).append(subsystem.name)
    for application, names in homes.items():
        session.say(Reason.of("console.runs_in", application=application, names=tuple(names)), Tone.HEAD)
        application_spots = [spots[name] for name in names if name in spots]
        if not application_spots:
            continue
        flow_index = flow_index_of(session, application_spots)
        for line in positions.lines(application_spots, flow_index, session.in_words):
            session.say(Reason.plain(f"  {line}"))
    if not homes:
        session.say(Reason.of("console.nothing_runs"), Tone.DIM)
    return ()


def where(session: ConsoleSession) -> tuple[Position, ...]:
    """Where the flows are of the applications that this console may steer."""
    answer = session.ask(steer.Who())
    if isinstance(answer, steer.Positions):
        return answer.flows
    return ()


def flow_index_of(session: ConsoleSession, spots: tuple[Position, ...] | list[Position]) -> FlowIndex:
    """These flows, with what their actions are called where this console began them."""
    names = {spot.subsystem for spot in spots}
    own = session.flow_index
    if own is not None and names and names <= set(own.subsystems):
        return own
    return FlowIndex.seen(spots)


def _order(session: ConsoleSession, message: request.Request) -> Faults:
    answer = session.ask(message)
    session.hear()
    if isinstance(answer, request.Refused):
        return (Fault(session.place, answer.reason, steering.GOES_ON),)
    return ()
