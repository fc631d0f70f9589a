"""Which parts of a world can be made; what cannot is left out, and told with its line (requirement X19)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import mujoco

from onika.model.world import UNNAMED, PartBlock, Spot
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of
from onika.workcell.composed.robot_model import compiled
from onika.workcell.composed.sources import SourceTexts

FREE_JOINT = "free"
"""The joint of a part that moves, behind the part's name."""

_MOST_NAMES = 20


@dataclass(frozen=True, slots=True)
class UsableParts:
    """Parts, each behind the one on which it stands, and the sites that they have."""

    parts: tuple[PartBlock, ...]
    sites: frozenset[str]


def prefix_of(name: str) -> str:
    """What stands before the names of a part's, or a robot's, model."""
    return "" if name == UNNAMED else f"{name}."


def part_spec(sources: SourceTexts, part: PartBlock) -> mujoco.MjSpec:
    """The document of a part, ready to be attached; raises ValueError with the reason why not."""
    child = sources.model(f"world/{part.file}")
    if part.free is not None:
        body = child.worldbody.first_body()
        if body is None:
            raise ValueError(Reason.of("workcell.part_without_body", part=part.name))
        if not len(body.joints):
            body.add_freejoint(name=FREE_JOINT)
    return child


def usable_parts(sources: SourceTexts, parts: Sequence[PartBlock], faults: list[Fault]) -> UsableParts:
    """Those of which a model can be compiled, and which stand on something that is there."""
    usable: list[PartBlock] = []
    sites: set[str] = set()
    for part in _in_order(parts):
        wrong = misplaced(part.spot, sites)
        if wrong is None:
            try:
                own = [site.name for site in part_spec(sources, part).sites]
                compiled(_alone(sources, part))
            except ValueError as why:
                wrong = "FILE", reason_of(why)
        if wrong is None:
            usable.append(part)
            sites |= {prefix_of(part.name) + name for name in own}
            continue
        place = Place(sources.place.file, part.lines.get(wrong[0], part.lines.get("PART", 0)))
        faults.append(Fault(place, wrong[1], Reason.of("workcell.part_left_out", part=part.name)))
    return UsableParts(tuple(usable), frozenset(sites))


def misplaced(spot: Spot, sites: set[str] | frozenset[str]) -> tuple[str, Reason] | None:
    """The keyword and the reason where something stands on a site that is not there."""
    if not spot.on or spot.on in sites:
        return None
    there = tuple(sorted(sites))[:_MOST_NAMES] or Reason.of("workcell.none")
    return "ON", Reason.of("workcell.no_such_name", there=there, name=spot.on)


def _alone(sources: SourceTexts, part: PartBlock) -> mujoco.MjSpec:
    """A world in which nothing is but this part, without what is only drawn."""
    spec = mujoco.MjSpec()
    spec.attach(part_spec(sources, part), frame=spec.worldbody.add_frame(), prefix=prefix_of(part.name))
    return spec


def _in_order(parts: Sequence[PartBlock]) -> Iterator[PartBlock]:
    """Parts, each behind the one on which it stands."""
    waiting, there = list(parts), set[str]()
    while waiting:
        part = next(part for part in waiting if not part.spot.on or part.spot.on.partition(".")[0] in there)
        waiting.remove(part)
        there.add(part.name)
        yield part
