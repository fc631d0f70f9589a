"""Lines that steer an application that runs, whoever began it (requirements E07, E08, E13, X03)."""

from collections.abc import Callable

from onika.desk.console import task_lines
from onika.desk.console.display import Tone
from onika.desk.console.session import Faults, Session
from onika.desk.plan.flow_index import Cast
from onika.desk.run import positions, steering
from onika.desk.run.steering import Order
from onika.desk.run.steering_fault import GOES_ON, objection
from onika.wire import request, steer
from onika.wire.steer import Position

Words = tuple[str, ...]


def verb(name: str) -> Callable[[Session, Words], Faults]:
    """What carries out this word of steering."""

    def carry_out(session: Session, words: Words) -> Faults:
        cast = cast_of(session, where(session))
        if not cast.parts:
            return session.no("an application that runs", "none")
        try:
            act = steering.act(" ".join((name, *words)), cast)
        except ValueError as wrong:
            return (objection(session.place, str(wrong), GOES_ON),)
        return _order(session, act.message) if isinstance(act, Order) else ()

    return carry_out


def clear(session: Session, words: Words) -> Faults:
    """Bring a task out of ERROR; of a flow that has stopped: clear its tasks and repeat its action."""
    spots = where(session)
    stopped = [spot.subsystem for spot in spots if spot.state == "stopped"]
    if words:
        flow = cast_of(session, spots).flow(words[0])
        return _order(session, steer.Recover(flow)) if flow else task_lines.clear(session, words)
    if session.subsystem in stopped or (stopped and not session.tasks()):
        name = session.subsystem if session.subsystem in stopped else stopped[0] if len(stopped) == 1 else ""
        return _order(session, steer.Recover(name))
    return task_lines.clear(session, words)


def who(session: Session, words: Words) -> Faults:
    """Where every flow is, and who waits for whom."""
    del words
    spots = where(session)
    if not spots:
        session.say("no application runs", Tone.DIM)
    else:
        session.show(positions.lines(spots, cast_of(session, spots)))
    return ()


def runs(session: Session, words: Words) -> Faults:
    """The applications that run, each with where its flows are."""
    del words
    spots = {spot.subsystem: spot for spot in where(session)}
    homes: dict[str, list[str]] = {}
    for subsystem in session.look_again().subsystems:
        if subsystem.application:
            homes.setdefault(subsystem.application, []).append(subsystem.name)
    for application, names in homes.items():
        session.say(f"{application} in {', '.join(names)}", Tone.HEAD)
        application_spots = [spots[name] for name in names if name in spots]
        for line in (
            positions.lines(application_spots, cast_of(session, application_spots)) if application_spots else ()
        ):
            session.say(f"  {line}")
    if not homes:
        session.say("no application runs", Tone.DIM)
    return ()


def where(session: Session) -> tuple[Position, ...]:
    """Where the flows are of the applications that this console may steer."""
    answer = session.ask(steer.Who())
    return answer.flows if isinstance(answer, steer.Positions) else ()


def cast_of(session: Session, spots: tuple[Position, ...] | list[Position]) -> Cast:
    """These flows, with what their actions are called where this console began them."""
    names = {spot.subsystem for spot in spots}
    own = session.cast
    return own if own is not None and names and names <= set(own.subsystems) else Cast.seen(spots)


def _order(session: Session, message: request.Request) -> Faults:
    answer = session.ask(message)
    session.hear()
    if isinstance(answer, request.Refused):
        return (objection(session.place, answer.reason, GOES_ON),)
    return ()
