"""Reachability: what an arm given by its constants can reach, and another arm's joint targets as its own (law 26).

Constants are those that a hardware task publishes (NDOF, SCREW, PARENT, BASE, TOOL, QMIN, QMAX, HOME), as arrays or as
plain lists.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.damped import STARTS
from onika.laws.frames import Array, Numbers, nine_of_pose, pose_of_nine
from onika.laws.inverse import Inverse, inverse_of
from onika.laws.screws import screws, slides
from onika.laws.sentence import LawSentence, sentence_of

Constants = Mapping[str, Any]
POSES = ("cartesian object", "guarded object")
"""Types of targets that begin with the nine numbers of a pose."""
_DIGITS = 17
"""More do not tell two numbers apart."""
_KINEMATICS = ("SCREW", "PARENT", "BASE", "TOOL", "QMIN", "QMAX")


def why_not(constants: Constants, targets: Sequence[tuple[str, Sequence[Any]]]) -> list[str | None]:
    """For each target (its type in lower case and its values) why it is out of reach; None: it is not, or unknown.

    A relative target begins where the one before it ends; where that is of another type, nobody knows where.
    """
    inverse = _inverse(constants)
    checks = {"joint object": _why_no_posture} | dict.fromkeys(POSES, _why_no_pose)
    reasons: list[str | None] = []
    before: Array | None = None
    for given, numbers in targets:
        kind, values = given, numbers
        if given == "relative object" and before is not None:
            kind, values = "cartesian object", _shifted(before, numbers)
        reason = checks[kind](constants, inverse, values) if kind in checks else None
        reasons.append(reason)
        before = _pose_after(constants, kind, values) if reason is None else None
    return reasons


def beyond_limits(constants: Constants, targets: Sequence[tuple[str, Sequence[Any]]]) -> list[str | None]:
    """For each target of axes that are no arm why it lies beyond a limit; None: it does not, or is of another type."""
    is_joint = [kind == "joint object" for kind, _ in targets]
    return [
        _why_beyond(constants, values, [False] * constants["NDOF"]) if joint else None
        for joint, (_, values) in zip(is_joint, targets, strict=True)
    ]


def poses(constants: Constants, targets: Sequence[Numbers]) -> list[Array]:
    """The Cartesian targets double[9] that joint targets are, whose first NDOF values count (rad, m)."""
    n = constants["NDOF"]
    arm = _arm(constants)
    return [nine_of_pose(arm.forward(target[:n])) for target in targets]


def postures(constants: Constants, poses: Sequence[Numbers], near: Numbers | None = None) -> list[Array | str]:
    """For each Cartesian target the joint values double[NDOF] nearest to those before it, or why there are none.

    The first is the one nearest to `near`, where nothing is said to HOME.
    """
    return list(postures_along(constants, poses, near))


def postures_along(
    constants: Constants, poses: Iterable[Numbers], near: Numbers | None = None, starts: int = STARTS
) -> Iterator[Array | str]:
    """As `postures`, one by one as they are asked for; `starts` as in `inverse_for`, 0 for a way without jumps."""
    inverse = _inverse(constants, starts)
    here = np.asarray(constants["HOME"] if near is None else near)
    for pose in poses:
        try:
            posture: Array | str = inverse.nearest(pose_of_nine(pose[:9]), here)
        except ValueError as wrong:
            posture = sentence_of(wrong)
        here = here if isinstance(posture, str) else posture
        yield posture


def transfer(
    theirs: Constants, ours: Constants, targets: Sequence[Numbers], near: Numbers | None = None
) -> list[Array | str]:
    """Joint targets of one arm as joint values of another, by way of the tool's pose in the world; or why not.

    Targets that both arms take in the same way, as those of the same kind at the same place, come back as they were.
    """
    if _are_alike(theirs, ours):
        return [np.array(target[: ours["NDOF"]], dtype=np.float64) for target in targets]
    return postures(ours, poses(theirs, targets), near)


def _are_alike(theirs: Constants, ours: Constants) -> bool:
    return all(np.array_equal(theirs[name], ours[name]) for name in _KINEMATICS)


def _arm(constants: Constants) -> ArmModel:
    screw, parent, base, tool = (constants[name] for name in ("SCREW", "PARENT", "BASE", "TOOL"))
    return ArmModel(screw, parent=parent, base=base, tool=tool)


def _inverse(constants: Constants, starts: int = STARTS) -> Inverse:
    return inverse_of(_arm(constants), constants["QMIN"], constants["QMAX"], starts)


def _shifted(pose: Array, shift: Sequence[Any]) -> list[float]:
    """The nine numbers of a pose moved along the axes of the world."""
    nine = nine_of_pose(pose)
    nine[6:9] += np.asarray(shift[:3], dtype=np.float64)
    return [float(number) for number in nine]


def _pose_after(constants: Constants, kind: str, values: Sequence[Any]) -> Array | None:
    """Where the tool is behind a target that is reached; None: nobody knows."""
    if kind == "joint object":
        return pose_of_nine(poses(constants, [values])[0])
    return pose_of_nine(values[:9]) if kind in POSES else None


def _why_no_posture(constants: Constants, _: Inverse, values: Sequence[Any]) -> str | None:
    return _why_beyond(constants, values, slides(screws(constants["SCREW"])).tolist())


def _why_beyond(constants: Constants, values: Sequence[Any], is_slide: Sequence[bool]) -> str | None:
    """Which of the joint values lies beyond a limit; None: none does."""
    n = constants["NDOF"]
    if len(values) < n:
        return LawSentence("laws.joint_values", "expected {n} joint values, found {count}", n=int(n), count=len(values))
    for k, (q, low, high) in enumerate(zip(values, constants["QMIN"], constants["QMAX"], strict=False), 1):
        if not low <= q <= high:
            return _beyond(k, float(q), float(low if q < low else high), slides=is_slide[k - 1])
    return None


def _beyond(joint: int, value: float, limit: float, *, slides: bool) -> LawSentence:
    """In as many digits as tell both apart: a little beyond is beyond, and nobody would believe equal numbers."""
    unit, usual = ("m", 3) if slides else ("rad", 2)
    told_apart = (digits for digits in range(usual, _DIGITS) if round(value, digits) != round(limit, digits))
    digits = next(told_apart, _DIGITS)
    value, limit = round(value, digits), round(limit, digits)
    if digits > usual:
        return LawSentence(
            "laws.joint_hair_beyond",
            "joint {joint} at {value} {unit} is beyond {limit}",
            joint=joint,
            value=value,
            unit=unit,
            limit=limit,
        )
    if slides:
        return LawSentence(
            "laws.joint_slide_beyond",
            "joint {joint} at {value:.3f} m is beyond {limit:.3f}",
            joint=joint,
            value=value,
            limit=limit,
        )
    return LawSentence(
        "laws.joint_value_beyond",
        "joint {joint} at {value:.2f} rad is beyond {limit:.2f}",
        joint=joint,
        value=value,
        limit=limit,
    )


def _why_no_pose(constants: Constants, inverse: Inverse, values: Sequence[Any]) -> str | None:
    try:
        posture = inverse.nearest(pose_of_nine(values[:9]), constants["HOME"])
    except ValueError as wrong:
        return sentence_of(wrong)
    return posture if isinstance(posture, str) else None
