"""A robot as a table of constants, named as state variables are, and what its hardware task publishes of it."""

import math
from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np

from onika.laws.frames import Array, rotation_of_rpy
from onika.laws.screws import parents_of_chain
from onika.laws.sentence import LawSentence
from onika.laws.textbook import links_of, load_of, screws_of, tool_of


class Robot(Protocol):
    """A module of constants such as `onika.laws.puma560`: a table, masses, load and tool as textbooks have them.

    All else has the shape and unit of the OUTCONST of its name.
    """

    ROBOT: str
    NDOF: int
    DH: Array
    DYN: Array
    LOAD: Array
    QMIN: Array
    QMAX: Array
    QDMAX: Array
    TAUMAX: Array
    KP: Array
    KD: Array
    TOOL: Array
    HOME: Array


_PUBLISHED = ("NDOF", "QMIN", "QMAX", "TAUMAX", "KP", "KD", "HOME", "ROBOT")


def published(robot: Robot, x: float, y: float, z: float, degrees: float) -> dict[str, Any]:
    """Everything that is known of a robot by the names of its OUTCONSTs; frame 0 at x y z (m), turned about z."""
    base = np.eye(4)
    base[:3, :3] = rotation_of_rpy(0.0, 0.0, math.radians(degrees))
    base[:3, 3] = x, y, z
    dh = robot.DH
    return {
        "SCREW": screws_of(dh),
        "LINK": links_of(dh, robot.DYN),
        "PARENT": parents_of_chain(robot.NDOF),
        "LOAD": load_of(dh, robot.LOAD),
        "TOOL": tool_of(dh, robot.TOOL),
        "BASE": base,
        "Q^_MAX": robot.QDMAX,
    } | {name: getattr(robot, name) for name in _PUBLISHED}


def unlike(name: str, constants: Mapping[str, Any], local_values: Mapping[str, Any]) -> LawSentence | None:
    """Why what a device says of itself is not the robot `name` with these constants: another one, or elsewhere."""
    if "ROBOT" not in local_values:
        return LawSentence(
            "laws.robot_no_robot", "expected the robot {name} behind the device, found another device", name=name
        )
    if local_values["ROBOT"] != name:
        return LawSentence(
            "laws.robot_another",
            "expected the robot {name} behind the device, found {other}",
            name=name,
            other=str(local_values["ROBOT"]),
        )
    if np.allclose(np.ravel(local_values["BASE"]), np.ravel(constants["BASE"]), atol=1e-6):
        return None
    x, y, z, turned = _place(constants["BASE"])
    found_x, found_y, found_z, found_turned = _place(local_values["BASE"])
    return LawSentence(
        "laws.robot_elsewhere",
        "expected frame 0 of the robot at {x:.4g} {y:.4g} {z:.4g} m, turned by {turned:.4g} degrees, "
        "found it at {found_x:.4g} {found_y:.4g} {found_z:.4g} m, turned by {found_turned:.4g} degrees",
        x=x,
        y=y,
        z=z,
        turned=turned,
        found_x=found_x,
        found_y=found_y,
        found_z=found_z,
        found_turned=found_turned,
    )


def _place(base: Any) -> tuple[float, float, float, float]:
    """Place of frame 0 in metres, and its turn about z in degrees."""
    frame = np.reshape(base, (4, 4))
    x, y, z = (float(value) + 0.0 for value in frame[:3, 3])
    return x, y, z, math.degrees(math.atan2(frame[1, 0], frame[0, 0])) + 0.0
