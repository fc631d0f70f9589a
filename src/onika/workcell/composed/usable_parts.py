"""Which parts of a world can be made; what cannot is left out, and told with its line (requirement X19)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import mujoco

from onika.model.world import UNNAMED, PartBlock, Spot
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of
from onika.workcell.composed.model_fault import OF_MODELS, ModelFault
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
    lost: Mapping[str, tuple[Place, ...]]
    """Where it is told of parts that cannot be used, by their names."""


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
    lost: dict[str, tuple[Place, ...]] = {}
    for part in _in_order(parts):
        fault = _misplaced(sources, part, sites, lost) or _unusable(sources, part)
        if fault is not None:
            faults.append(fault)
            lost[part.name] = (fault.place,)
            continue
        usable.append(part)
        sites |= {prefix_of(part.name) + site.name for site in part_spec(sources, part).sites}
    return UsableParts(tuple(usable), frozenset(sites), lost)


def carrier_of(spot: Spot) -> str:
    """The part on which something stands."""
    return spot.on.partition(".")[0]


def _misplaced(
    sources: SourceTexts, part: PartBlock, sites: set[str], lost: Mapping[str, tuple[Place, ...]]
) -> Fault | None:
    """Where a part stands on a site that is not there."""
    wrong = misplaced(part.spot, sites)
    return None if wrong is None else _fault(sources, part, *wrong, because=lost.get(carrier_of(part.spot), ()))


def _unusable(sources: SourceTexts, part: PartBlock) -> Fault | None:
    """A model that cannot be used: at its own line where that is known, else at that of the world."""
    try:
        compiled(_alone(sources, part))
    except ValueError as why:
        wrong, reason = why, reason_of(why)
    else:
        return None
    if reason.key in OF_MODELS:
        wrong = sources.model_fault(reason, {prefix_of(part.name): f"world/{part.file}"})
    if isinstance(wrong, ModelFault) and wrong.place.line:
        return Fault(wrong.place, reason, Reason.of("workcell.part_left_out", part=part.name), because=(wrong.place,))
    fault = _fault(sources, part, "FILE", reason)
    return replace(fault, because=(fault.place,))  # it may have been told already that a file is not there


def _fault(
    sources: SourceTexts, part: PartBlock, keyword: str, reason: Reason, because: tuple[Place, ...] = ()
) -> Fault:
    place = Place(sources.place.file, part.lines.get(keyword, part.lines.get("PART", 0)))
    return Fault(place, reason, Reason.of("workcell.part_left_out", part=part.name), because=because)


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
