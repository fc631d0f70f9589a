"""Console command `again`: what found no gap between the cycles of its unit, in another way (law 21)."""

from msgspec import structs

from onika.desk.console.session import ConsoleSession, Faults
from onika.wire import live
from onika.words.reason import Reason

Words = tuple[str, ...]
HOLD = "hold"


def again(session: ConsoleSession, words: Words) -> Faults:
    """Do what found no gap last: in a moment of hold, or with its newcomers on a unit that is named."""
    tight = session.without_gap
    if tight is None:
        return session.no(Reason.of("console.nothing_without_gap"))
    if words == (HOLD,):
        return session.order(structs.replace(tight.order, holds=True))
    if not isinstance(tight.order, live.Change):
        return session.no(Reason.of("console.code_stays_on_unit"))
    units = tuple(unit.name for unit in session.standing().rtpus if not unit.is_lost)
    if words[0] not in units:
        return session.no(Reason.of("console.unit_unknown", units=units, rtpu=words[0]))
    return session.order(_on(tight.order, tight.tasks, words[0]))


def _on(order: live.Change, tasks: Words, unit: str) -> live.Change:
    """A change whose newcomers, as far as they found no gap, live on another unit."""
    spawn = tuple(structs.replace(task, rtpu=unit) if task.name in tasks else task for task in order.spawn)
    return structs.replace(order, spawn=spawn)
