"""A servo within the step of physics: any actuator of a joint becomes one, without tuning.

kp = w2 M, but firm against dry friction; kv is critical; the wanted speed is fed ahead, so that no lag is left. M is
the inertia that the joint feels at home. The weight of the links is borne by the drive.
"""

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array

FREQUENCY = 100.0
"""Natural frequency (rad/s)."""

_FINGER_FREQUENCY = 300.0
_FIRM = 500.0  # how much stiffer than dry friction is strong (1/rad): it then leaves 2 mrad at most


@dataclass(frozen=True, slots=True)
class Gains:
    """Stiffness, damping, and what a wanted speed adds to the wanted position, of each joint.

    A spring that the model has in a joint pulls it towards `slack`, with `spring` as a part of the servo's stiffness.
    """

    kp: Array
    kv: Array
    lead: Array
    spring: Array
    slack: Array

    def against_springs(self, goal: Array) -> Array:
        """The signal that holds the joints at a goal."""
        return goal + self.spring * (goal - self.slack) if self.spring.any() else goal


def gains(
    inertia: Array, damping: Array, friction: Array, spring: Array, slack: Array, frequency: float = FREQUENCY
) -> Gains:
    """Of joints with these inertias (kg m2; kg), viscous damping, dry friction, and springs slack at `slack`."""
    kp: Array = np.maximum(frequency**2 * inertia, _FIRM * friction)
    kv: Array = 2.0 * np.sqrt(kp * np.maximum(inertia, kp / frequency**2))
    lead: Array = (kv + damping) / kp
    return Gains(kp, kv, lead, spring / kp, slack)


def finger_gains(model: Any, actuators: Array) -> Gains:
    """Of the motors of fingers: so firm that a finger presses as hard as it may some millimetres before its goal."""
    mass = np.array([_felt_mass(model, actuator) for actuator in actuators.tolist()])
    none = np.zeros(len(actuators))
    return gains(mass, none, none, none, none, _FINGER_FREQUENCY)


def _felt_mass(model: Any, actuator: int) -> float:
    """What a motor moves, for each metre of its length (kg), or radian (kg m2), where the model stands at first."""
    gear = max(abs(float(model.actuator_gear[actuator, 0])), 1e-9)
    if int(model.actuator_trntype[actuator]) == int(mujoco.mjtTrn.mjTRN_JOINT):
        dof = int(model.jnt_dofadr[model.actuator_trnid[actuator, 0]])
        return float(np.ravel(model.dof_M0[dof])[0]) / gear**2
    return 1.0 / max(gear * float(model.actuator_acc0[actuator]), 1e-9)


def felt_inertia(model: Any, data: Any, dofs: Array) -> Array:
    """The diagonal of the mass matrix at these degrees of freedom, where the data stands."""
    mujoco.mj_forward(model, data)
    unit, row = np.zeros(model.nv), np.zeros(model.nv)
    felt = np.zeros(len(dofs))
    for k, dof in enumerate(dofs):
        unit[:] = 0.0
        unit[dof] = 1.0
        mujoco.mj_mulM(model, data, row, unit)
        felt[k] = row[dof]
    return felt


def make_servo(model: Any, actuators: Array, given: Gains) -> None:
    """Let these actuators follow positions."""
    _clear(model, actuators)
    model.actuator_gainprm[actuators, 0] = given.kp
    model.actuator_biastype[actuators] = int(mujoco.mjtBias.mjBIAS_AFFINE)
    model.actuator_biasprm[actuators, 1] = -given.kp
    model.actuator_biasprm[actuators, 2] = -given.kv


def make_rate_servo(model: Any, actuators: Array, strength: Array) -> None:
    """Let these actuators follow speeds; `strength` is their force, or torque, per speed that is lacking."""
    _clear(model, actuators)
    model.actuator_gainprm[actuators, 0] = strength
    model.actuator_biastype[actuators] = int(mujoco.mjtBias.mjBIAS_AFFINE)
    model.actuator_biasprm[actuators, 2] = -strength


def make_motor(model: Any, actuators: Array) -> None:
    """Let these actuators pull with the torque that they are told."""
    _clear(model, actuators)
    model.actuator_gainprm[actuators, 0] = 1.0


def limit(model: Any, actuators: Array, highest: Array) -> None:
    """The highest force of these actuators; they act on their joints without a gear."""
    model.actuator_forcelimited[actuators] = 1
    model.actuator_forcerange[actuators] = np.stack((-highest, highest), axis=1)
    model.actuator_gear[actuators] = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def _clear(model: Any, actuators: Array) -> None:
    model.actuator_gaintype[actuators] = int(mujoco.mjtGain.mjGAIN_FIXED)
    model.actuator_biastype[actuators] = int(mujoco.mjtBias.mjBIAS_NONE)
    model.actuator_gainprm[actuators] = 0.0
    model.actuator_biasprm[actuators] = 0.0
    model.actuator_ctrllimited[actuators] = 0
