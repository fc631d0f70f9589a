"""A robot as a table of constants, named as state variables are, and what its hardware task publishes of it."""

import math
from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np

from onika.laws.frames import Array, rotation_of_rpy


class Robot(Protocol):
    """A module of constants such as `onika.laws.puma560`; shapes and units are those of the OUTCONSTs."""

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


_PUBLISHED = ("NDOF", "DH", "DYN", "LOAD", "QMIN", "QMAX", "TAUMAX", "KP", "KD", "TOOL", "ROBOT")


def published(robot: Robot, x: float, y: float, z: float, degrees: float) -> dict[str, Any]:
    """Everything that is known of a robot by the names of its OUTCONSTs; frame 0 at x y z (m), turned about z."""
    base = np.eye(4)
    base[:3, :3] = rotation_of_rpy(0.0, 0.0, math.radians(degrees))
    base[:3, 3] = x, y, z
    return {"BASE": base, "Q^_MAX": robot.QDMAX} | {name: getattr(robot, name) for name in _PUBLISHED}


def unlike(name: str, constants: Mapping[str, Any], local_values: Mapping[str, Any]) -> str | None:
    """Why what a device says of itself is not the robot `name` with these constants: another one, or elsewhere."""
    if local_values.get("ROBOT") != name:
        return f"expected the robot {name} behind the device, found {local_values.get('ROBOT', 'another device')}"
    if np.allclose(np.ravel(local_values["BASE"]), np.ravel(constants["BASE"]), atol=1e-6):
        return None
    return f"expected frame 0 of the robot at {_place(constants['BASE'])}, found it at {_place(local_values['BASE'])}"


def _place(base: Any) -> str:
    frame = np.reshape(base, (4, 4))
    turned = math.degrees(math.atan2(frame[1, 0], frame[0, 0]))
    return " ".join(f"{value + 0.0:.4g}" for value in frame[:3, 3]) + f" m, turned by {turned + 0.0:.4g} degrees"
