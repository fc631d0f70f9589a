"""The standstill: flows that wait for what never comes, in a circle or for one that stands (requirements X03, X06).

A flow that is neither waiting nor over can still come to a tag. A waiting one goes on if all that it waits for can.
Whoever is left waits for ever, unless somebody lets it pass.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise

from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.wire.steer import Position
from onika.words.reason import Reason

_WAITING = ("waiting", "joining")
_OVER = ("killing", "ended")
_STANDING = ("done", "stopped")
"""Flows that come nowhere."""


def causes(positions: Sequence[Position]) -> tuple[Cause, ...]:
    """Every circle of waiting flows, once; then every flow that waits for one that has ended or stands still.

    Equal positions give equal causes, so whoever asks at each move sees which are new. None once the run is over.
    """
    if any(position.state in _OVER for position in positions):
        return ()
    flows = {position.subsystem: position for position in positions}
    leads = _leads(flows)
    circles, deserted = [], []
    told: set[str] = set()
    for name in leads:
        way = _way(name, leads)
        if way[-1] in way[:-1]:
            circle = _turned(way[way.index(way[-1]) : -1], flows)
            if not told & set(circle):
                circles.append(Cause(CauseKind.DEADLOCK, _circle(circle, flows), circle[0]))
            told |= set(circle)
        else:
            deserted.append(Cause(CauseKind.DESERTED, _chain(way, flows), name))
    return (*circles, *deserted)


def waiting_for(subsystem: str, positions: Sequence[Position]) -> tuple[tuple[str, str], ...]:
    """The flows that wait for this one, directly or through others, nearest first, each with the tag of the file."""
    found: dict[str, str] = {}
    wanted = [subsystem]
    for name in wanted:
        for position in positions:
            if name in position.waits_for and position.subsystem not in found and position.subsystem != subsystem:
                found[position.subsystem] = tag_of(position)
                wanted.append(position.subsystem)
    return tuple(found.items())


def tag_of(position: Position) -> str:
    """The tag at which a flow waits as its file says it; empty where it waits for nested flows."""
    return position.tag.rpartition(" ")[2]


def last_of(subsystem: str, positions: Sequence[Position]) -> str:
    """Where the waiting of a flow that waits in no circle leads: the flow that has ended or stands still."""
    return _way(subsystem, _leads({position.subsystem: position for position in positions}))[-1]


def _leads(flows: Mapping[str, Position]) -> dict[str, str]:
    """Each flow that waits for ever, and the first flow that keeps it."""
    able = {name for name, flow in flows.items() if flow.state not in (*_WAITING, *_STANDING)}
    while True:
        new = {
            n
            for n, flow in flows.items()
            if n not in able and flow.state in _WAITING and able.issuperset(flow.waits_for)
        }
        if not new:
            break
        able |= new
    stuck = (flow for name, flow in flows.items() if name not in able and flow.state in _WAITING)
    return {position.subsystem: next(name for name in position.waits_for if name not in able) for position in stuck}


def _way(name: str, leads: Mapping[str, str]) -> list[str]:
    """From a flow to whoever keeps it, and on, up to one that does not wait or was met already."""
    way = [name]
    while way[-1] in leads and way[-1] not in way[:-1]:
        way.append(leads[way[-1]])
    return way


def _turned(circle: list[str], flows: Mapping[str, Position]) -> list[str]:
    """The same circle, from its first flow in the plan's order on; without the one that closes it."""
    order = list(flows)
    first = min(range(len(circle)), key=lambda place: order.index(circle[place]))
    return circle[first:] + circle[:first]


def _circle(circle: Sequence[str], flows: Mapping[str, Position]) -> Reason:
    followers = [*circle[1:], circle[0]]
    pairs = zip(circle, followers, strict=True)
    waits = [Reason.of("host.flow_does", flow=name, what=_waits(flows[name], other)) for name, other in pairs]
    return Reason.of("host.none_goes_on", waits=tuple(waits))


def _chain(way: Sequence[str], flows: Mapping[str, Position]) -> Reason:
    what = _stands(flows.get(way[-1]))
    for name, other in reversed(list(pairwise(way))):
        what = Reason.of("host.which", waits=_waits(flows[name], other), what=what)
    return Reason.of("host.flow_does", flow=way[0], what=what)


def _stands(last: Position | None) -> Reason:
    """What the flow does to which a chain leads."""
    match last.state if last is not None else "":
        case "done":
            return Reason.of("host.has_ended")
        case "stopped":
            return Reason.of("host.stands_at_error")
        case _:
            return Reason.of("host.is_gone")


def _waits(position: Position, other: str) -> Reason:
    tag = tag_of(position)
    if tag:
        return Reason.of("host.waits_at", tag=tag, flow=other)
    return Reason.of("host.waits_for", flow=other)
