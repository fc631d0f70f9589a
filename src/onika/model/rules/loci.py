"""Where the lines of a variable meet: how loci are born, stay and end (dissertation §5.3.5, requirement C24)."""

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace

from onika.model.configuration import Configuration, Locus, Placed
from onika.model.rules.box import Pin, TaskBox
from onika.model.rules.uses import Uses, apart, of_locus, tasks

_OUT = 24
"""Pixels between a pin and the locus that it has for itself."""

_STEP = 10
"""Pixels that a locus is moved by, both ways, until no icon lies under it (§5.3.5)."""

_CLEAR = 6
"""Pixels kept between a locus and an icon."""


@dataclass(frozen=True, slots=True)
class _User:
    placed: Placed
    box: TaskBox
    pin: Pin

    @property
    def at(self) -> tuple[int, int]:
        return self.box.reach(self.pin, self.placed.x, self.placed.y, self.placed.in_left)

    @property
    def beside(self) -> tuple[int, int]:
        x, y = self.at
        return x + _OUT * self.box.outward(self.pin, self.placed.in_left), y


def settled(
    configuration: Configuration,
    boxes: Mapping[str, TaskBox],
    former: Configuration,
    former_boxes: Mapping[str, TaskBox] | None = None,
) -> Configuration:
    """The configuration with one locus for each variable that its tasks use; `boxes` are those of its tasks.

    A locus is born beside its first pin, goes half-way when the second task comes and then stays; back to one task
    it goes beside that pin, and with the last one it is gone. Loci of tasks whose box is missing are kept.
    `former_boxes`: those of the former configuration, where they were others.
    """
    counts = _counts(configuration.placed, boxes)
    gone, come = _exchanged(configuration, boxes, former, boxes if former_boxes is None else former_boxes)
    standing = {locus.svar: locus for locus in configuration.loci}
    going = set()
    for svar in {*(counts.keys() - standing.keys()), *gone, *come} & counts.keys():
        now = tasks(counts[svar])
        if _goes(now, now + gone.get(svar, 0) - come.get(svar, 0), svar in standing):
            going.add(svar)
    spots = _spots(going, configuration.placed, boxes, _icons(configuration.placed, boxes)) if going else {}
    unknown = any(placed.task not in boxes for placed in configuration.placed)
    loci = []
    for svar in dict.fromkeys((*standing, *counts)):
        if svar in counts:
            loci.append(_locus(standing.get(svar) or Locus(svar), spots.get(svar), counts[svar]))
        elif unknown:
            loci.append(standing[svar])
    return replace(configuration, loci=tuple(loci))


def flipped(configuration: Configuration, names: Sequence[str], boxes: Mapping[str, TaskBox]) -> Configuration:
    """The loci that only one of these tasks uses follow it to its other side."""
    counts = _counts(configuration.placed, boxes)
    turned = {pin.svar for name in names if name in boxes for pin in boxes[name].pins}
    alone = {svar for svar in turned if svar in counts and tasks(counts[svar]) == 1}
    follow = _spots(alone, configuration.placed, boxes, _icons(configuration.placed, boxes))
    loci = (
        replace(locus, x=follow[locus.svar][0], y=follow[locus.svar][1]) if locus.svar in follow else locus
        for locus in configuration.loci
    )
    return replace(configuration, loci=tuple(loci))


def wished(configuration: Configuration, spots: Mapping[str, Locus], boxes: Mapping[str, TaskBox]) -> Configuration:
    """The loci of some variables as these say: where they are, but kept off icons, and whether they are shown."""
    icons = _icons(configuration.placed, boxes)
    loci = []
    for locus in configuration.loci:
        wish = spots.get(locus.svar)
        if wish is None:
            loci.append(locus)
        else:
            x, y = _clear_of((wish.x, wish.y), icons)
            loci.append(replace(locus, x=x, y=y, show=wish.show))
    return replace(configuration, loci=tuple(loci))


def _exchanged(
    configuration: Configuration,
    boxes: Mapping[str, TaskBox],
    former: Configuration,
    former_boxes: Mapping[str, TaskBox],
) -> tuple[dict[str, int], dict[str, int]]:
    """How many tasks have left each variable, and how many have come to it."""
    before = {placed.task: former_boxes.get(placed.task) for placed in former.placed}
    after = {placed.task: boxes.get(placed.task) for placed in configuration.placed}
    gone: dict[str, int] = {}
    come: dict[str, int] = {}
    for name in before.keys() | after.keys():
        old, new = before.get(name), after.get(name)
        if old is new:
            continue
        for svar in old.uses if old else ():
            gone[svar] = gone.get(svar, 0) + 1
        for svar in new.uses if new else ():
            come[svar] = come.get(svar, 0) + 1
    return gone, come


def _goes(now: int, before: int, stands: bool) -> bool:
    """Whether a locus is born, or its second task has come, or it is back to one."""
    return not stands or (now >= 2 and before == 1) or (now == 1 and before > 1)


def _spots(
    svars: Set[str], placed: Sequence[Placed], boxes: Mapping[str, TaskBox], icons: Sequence[tuple[int, int, int, int]]
) -> dict[str, tuple[int, int]]:
    """Where loci go that go anywhere."""
    places = {}
    for svar, users in _users(svars, placed, boxes).items():
        second = next((user for user in users if user.placed.task != users[0].placed.task), None)
        spot = users[0].beside if second is None else _half_way(users[0].at, second.at)
        places[svar] = _clear_of(spot, icons)
    return places


def _locus(standing: Locus, spot: tuple[int, int] | None, used: Uses) -> Locus:
    """With its spot and what the file counts; the same object where nothing is new."""
    if spot is not None:
        standing = replace(standing, x=spot[0], y=spot[1])
    if of_locus(standing) == used:
        return standing
    conns, inconst, outconst, invar, outvar, double_in = apart(used)
    return replace(
        standing, conns=conns, inconst=inconst, outconst=outconst, invar=invar, outvar=outvar, double_in=double_in
    )


def _half_way(place: tuple[int, int], other: tuple[int, int]) -> tuple[int, int]:
    return (place[0] + other[0]) // 2, (place[1] + other[1]) // 2


def _icons(placed: Sequence[Placed], boxes: Mapping[str, TaskBox]) -> list[tuple[int, int, int, int]]:
    """The areas that loci are kept off: left, right, top, bottom."""
    return [
        (placed.x - _CLEAR, placed.x + box.width + _CLEAR, placed.y - _CLEAR, placed.y + box.height + _CLEAR)
        for placed in placed
        if (box := boxes.get(placed.task)) is not None
    ]


def _clear_of(spot: tuple[int, int], icons: Sequence[tuple[int, int, int, int]]) -> tuple[int, int]:
    x, y = spot
    while any(left < x < right and top < y < bottom for left, right, top, bottom in icons):
        x, y = x + _STEP, y + _STEP
    return x, y


def _users(svars: Set[str], placed: Sequence[Placed], boxes: Mapping[str, TaskBox]) -> dict[str, list[_User]]:
    """The pins of these variables."""
    users: dict[str, list[_User]] = {}
    for each in placed:
        box = boxes.get(each.task)
        if box is None or svars.isdisjoint(box.uses):
            continue
        for pin in box.pins:
            if pin.svar in svars:
                users.setdefault(pin.svar, []).append(_User(each, box, pin))
    return users


def _counts(placed: Sequence[Placed], boxes: Mapping[str, TaskBox]) -> dict[str, Uses]:
    """How each variable is used, in the order in which they are first used."""
    uses: dict[str, Uses] = {}
    for each in placed:
        box = boxes.get(each.task)
        if box is not None:
            for svar, used in box.uses.items():
                uses[svar] = uses.get(svar, 0) + used
    return uses
