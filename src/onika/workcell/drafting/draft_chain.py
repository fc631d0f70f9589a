"""Which joints of a model make its arm, and where the tool is: guessed from tree and names (requirement X19)."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.words.reason import Reason

_FINGER = re.compile(r"grip|finger|jaw|knuckle|thumb", re.IGNORECASE)
_TOOL = re.compile(r"tool|tcp|pinch|grasp|grip|attach|flange|ee\b|_ee|end.?eff|tip|hook", re.IGNORECASE)
_POINT = re.compile(r"tcp|pinch|grasp|ee\b|_ee|end.?eff|tip", re.IGNORECASE)
MOVING = (int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE))
"""Joints that arms consist of."""
_FAR_M = 0.02  # a tool nearer to the last joint than this says nothing of a direction


@dataclass(frozen=True, slots=True)
class DraftChain:
    """The joints of an arm by their numbers in the model; `start` is the body FROM which they go, empty: as usual."""

    joints: tuple[int, ...]
    last: int
    """The body that the last joint moves."""
    start: str
    notes: tuple[Reason, ...]


@dataclass(frozen=True, slots=True)
class DraftTool:
    """A site or body, the offset from it (m), and two directions of it."""

    name: str
    offset: tuple[float, ...]
    approach: str
    fingers: str
    origin: Reason
    """Where it comes from."""


def draft_chain(model: Any, taken: Sequence[int] = ()) -> DraftChain | None:
    """The longest run of joints that does not branch, without fingers at its end; None: nothing moves.

    taken   joints of a base, which are none of the arm on it
    """
    driven = driven_joints(model)
    joints = max((_usable(model, run, driven - {*taken}) for run in _runs(model, driven)), key=len, default=())
    if not joints:
        return None
    first = int(model.jnt_bodyid[joints[0]])
    above = [body for body in bearers(model, first) if model.body_jntnum[body]]
    loose = tuple(
        model.joint(joint).name
        for body in reversed(above)
        for joint in _joints(model, body)
        if joint not in {*driven, *taken} and not _is_free(model, joint)
    )
    notes = [Reason.of("workcell.draft_floats", body=model.body(above[-1]).name)] if _floats(model, above) else []
    notes += [Reason.of("workcell.draft_loose", joints=loose)] if loose else []
    start = model.body(int(model.body_parentid[first])).name if above else ""
    return DraftChain(joints, int(model.jnt_bodyid[joints[-1]]), start, tuple(notes))


def driven_joints(model: Any) -> set[int]:
    """The joints at which an actuator stands."""
    return {int(of) for kind, of in zip(model.actuator_trntype, model.actuator_trnid[:, 0], strict=True) if not kind}


def below(model: Any, body: int) -> list[int]:
    """A body and all that it bears."""
    return [other for other in range(1, model.nbody) if other == body or body in bearers(model, other)]


def _fixed_to(model: Any, body: int) -> list[int]:
    """A body and all that moves with it as one piece."""
    return [at for at in below(model, body) if int(model.body_weldid[at]) == int(model.body_weldid[body])]


def draft_tool(model: Any, data: Any, chain: DraftChain, fingers: Sequence[int]) -> DraftTool:
    """The tool of a chain, with the data at home; `fingers` are the bodies that fingers move."""
    there = [body for body in _fixed_to(model, chain.last) if body not in fingers]
    sites = [k for k in range(model.nsite) if int(model.site_bodyid[k]) in there and model.site(k).name]
    site = next(_by_name(sites, {k: model.site(k).name for k in sites}), None)
    if site is not None:
        frame, at, name = data.site_xmat[site], data.site_xpos[site], model.site(site).name
        origin, offset = Reason.of("workcell.draft_tool_site"), np.zeros(3)
    else:
        named = [body for body in there if body != chain.last and _TOOL.search(model.body(body).name)]
        body = (named or [chain.last])[0]
        frame, at, name = data.xmat[body], data.xpos[body], model.body(body).name
        origin = Reason.of("workcell.draft_tool_body")
        offset = np.zeros(3)
        points = [part for part in named if _POINT.search(model.body(part).name)]
        if points:
            body = points[0]
            frame, at, name = data.xmat[body], data.xpos[body], model.body(body).name
            origin = Reason.of("workcell.draft_tool_named")
        elif fingers:
            between = np.mean([data.xipos[finger] for finger in fingers], axis=0)
            offset = np.round(frame.reshape(3, 3).T @ (between - at), 4)
            at, origin = between, Reason.of("workcell.draft_tool_between")
    turn = frame.reshape(3, 3)
    approach = _nearest(turn.T @ (at - data.xpos[chain.last]), "z", _FAR_M)
    along = _way_of_fingers(model, data, fingers)
    across = turn.T @ along
    across["xyz".index(approach[-1])] = 0.0
    usual = "y" if approach[-1] != "y" else "z"
    return DraftTool(name, tuple(offset.tolist()), approach, _nearest(across, usual, 1e-3)[-1], origin)


def _runs(model: Any, driven: set[int]) -> Iterator[list[int]]:
    """The moving bodies of each branch of the tree, from where it begins to where it branches again.

    A rod that nothing drives, as one of a parallelogram, is no branch.
    """
    moving = [body for body in range(1, model.nbody) if _is_moving(model, body)]
    bearer = {body: next((at for at in bearers(model, body) if at in moving), 0) for body in moving}
    led = {at for body in moving if driven & {*_joints(model, body)} for at in (body, *bearers(model, body))}
    borne: Mapping[int, list[int]] = {
        at: [body for body in moving if bearer[body] == at and body in led and not _is_finger(model, body)]
        for at in [0, *moving]
    }
    for body in moving:
        if bearer[body] and borne[bearer[body]] == [body]:
            continue  # it goes on a run that began before
        run, at = [body], body
        while len(borne[at]) == 1:
            at = borne[at][0]
            run.append(at)
        yield run


def _usable(model: Any, run: Sequence[int], driven: set[int]) -> tuple[int, ...]:
    """The joints of the longest part of a run that is driven throughout, without fingers at its end."""
    longest: list[int] = []
    part: list[int] = []
    for body in run:
        joints = [*_joints(model, body)]
        part = [*part, *joints] if driven.issuperset(joints) else []
        longest = max(longest, part, key=len)
    while longest and (_FINGER.search(model.joint(longest[-1]).name) or _has_twin(model, longest)):
        longest.pop()
    return tuple(longest)


def _has_twin(model: Any, joints: Sequence[int]) -> bool:
    """Whether the last of several joints goes with one beside it, as a finger does."""
    bearer = {joint: int(model.body_parentid[int(model.jnt_bodyid[joint])]) for joint in range(model.njnt)}
    last = joints[-1]
    return len(joints) > 1 and any(last in pair and bearer[pair[0]] == bearer[pair[1]] for pair in couplings(model))


def couplings(model: Any) -> list[tuple[int, int]]:
    """The joints of which one follows the other."""
    bonds = [k for k in range(model.neq) if int(model.eq_type[k]) == int(mujoco.mjtEq.mjEQ_JOINT)]
    pairs = [(int(model.eq_obj1id[k]), int(model.eq_obj2id[k])) for k in bonds]
    return [pair for pair in pairs if -1 not in pair]


def _is_moving(model: Any, body: int) -> bool:
    kinds = [int(model.jnt_type[joint]) for joint in _joints(model, body)]
    return bool(kinds) and all(kind in MOVING for kind in kinds)


def _is_finger(model: Any, body: int) -> bool:
    return any(_FINGER.search(model.joint(joint).name) for joint in _joints(model, body))


def _joints(model: Any, body: int) -> range:
    first = int(model.body_jntadr[body])
    return range(first, first + int(model.body_jntnum[body]))


def bearers(model: Any, body: int) -> list[int]:
    """The bodies that bear a body, the nearest first, without the world."""
    bodies = []
    at = int(model.body_parentid[body])
    while at:
        bodies.append(at)
        at = int(model.body_parentid[at])
    return bodies


def _floats(model: Any, above: Sequence[int]) -> bool:
    return any(_is_free(model, joint) for body in above for joint in _joints(model, body))


def _is_free(model: Any, joint: int) -> bool:
    return int(model.jnt_type[joint]) == int(mujoco.mjtJoint.mjJNT_FREE)


def _by_name(numbers: Sequence[int], names: Mapping[int, str]) -> Iterator[int]:
    """Those that are called like a tool first."""
    yield from (number for number in numbers if _TOOL.search(names[number]))
    yield from numbers


def _way_of_fingers(model: Any, data: Any, fingers: Sequence[int]) -> Array:
    """The direction along which fingers move in the world: where one slides, else from one to the other."""
    joints = [joint for body in fingers for joint in _joints(model, body)]
    slides = [joint for joint in joints if int(model.jnt_type[joint]) == MOVING[1]]
    if slides:
        return np.array(data.xaxis[slides[0]])
    if len(fingers) > 1:
        return np.array(data.xipos[fingers[-1]] - data.xipos[fingers[0]])
    return np.zeros(3)


def _nearest(way: Array, usual: str, least: float) -> str:
    """The axis that is nearest to a direction; the usual one where it is too short."""
    axis = int(np.argmax(np.abs(way)))
    if abs(way[axis]) < least:
        return usual
    return ("-" if way[axis] < 0.0 else "") + "xyz"[axis]
