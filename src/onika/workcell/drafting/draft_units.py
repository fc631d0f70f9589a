"""Where lengths or angles of a model seem to be of another unit than it says: told of its size (requirement X19)."""

from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np

from onika.words.reason import Reason
from onika.workcell.composed.joint_facts import JointFacts

_MOST_TURN = 25.0  # a joint goes no further than four turns either way; 30 degrees are more than that (rad)
_LARGER = 20.0  # so much larger than the arm is no mesh of it
_LEAST_M = 0.05  # of an arm whose joints all stand at one point


def doubtful_units(model: Any, arm: JointFacts) -> Iterator[Reason]:
    """What is to be told of a model whose limits look like degrees, or whose meshes look like millimetres."""
    hinges = [model.joint(name) for name in arm.joints]
    hinges = [joint for joint in hinges if int(joint.type[0]) == int(mujoco.mjtJoint.mjJNT_HINGE)]
    furthest = {joint.name: float(np.abs(joint.range).max()) for joint in hinges}
    far = tuple(name for name, most in furthest.items() if most > _MOST_TURN)
    if far:
        yield Reason.of("workcell.draft_degrees", joints=far, most=max(furthest.values()))
    largest = max((_size(model, geom) for geom in range(model.ngeom) if _is_mesh(model, geom)), default=0.0)
    reach = max(_reach(model, arm), _LEAST_M)
    if largest > _LARGER * reach:
        yield Reason.of("workcell.draft_millimetres", size=round(largest, 2), reach=round(reach, 2))


def _is_mesh(model: Any, geom: int) -> bool:
    return int(model.geom_type[geom]) == int(mujoco.mjtGeom.mjGEOM_MESH)


def _size(model: Any, geom: int) -> float:
    """The longest side of the box around a shape (m)."""
    return 2.0 * float(np.max(model.geom_aabb[geom, 3:]))


def _reach(model: Any, arm: JointFacts) -> float:
    """How far the arm reaches when it is straight, from joint to joint (m)."""
    bodies = [int(model.jnt_bodyid[model.joint(name).id]) for name in arm.joints]
    return float(sum(np.linalg.norm(model.body_pos[body]) for body in bodies[1:]))
