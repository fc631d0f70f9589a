"""An arm, or axes, of a robot from a file as a device; its servo stands within the step of physics (requirement X19).

    position   a command is joint values and speeds; between commands the values run on with the speeds
    velocity   a command is speeds; the drive adds them up, and follows the sum
    torque     a command is torques; while the drive holds, its motors are servos

Holding, it stays where it was told to be last, a torque device where it then is.
"""

import math
from collections.abc import Sequence
from typing import Any, ClassVar, NamedTuple

import numpy as np

from onika.laws.arm_identity import WITHOUT_FORCES
from onika.laws.frames import Array
from onika.model.robot import Numbers
from onika.ring.device import DeviceSheet
from onika.ring.drive import DriveMode
from onika.workcell.composed.joint_facts import JointFacts
from onika.workcell.composed.robot_unit import FORCELESS, RobotUnit
from onika.workcell.composed.servo import limit, make_motor, make_servo
from onika.workcell.plant import Plant
from onika.workcell.unit import row_of

_COMMANDS = {"position": ("q", "v"), "velocity": ("v",), "torque": ("tau",)}
"""What a command consists of, for each joint."""


_POSTURE = 0.02  # how far a joint may be from home (rad; m where it slides)


class _Rows(NamedTuple):
    """Views on what a plant knows of joints and motors that stand side by side there, as those of a chain do."""

    places: Any
    speeds: Any
    driven: Array
    borne: Array
    signals: Any


class JointUnit(RobotUnit):
    """A device of joints by its name at a place; `prefix` stands there before the names of its robot's model."""

    def __init__(
        self, name: str, facts: JointFacts, robot: str, place: str, prefix: str, step_s: float, base: Numbers
    ) -> None:
        self.facts = facts
        joints = range(1, len(facts.joints) + 1)
        identity = dict(facts.constants) | ({"BASE": base} if facts.start else {})
        identity["DRIVE"] = self._driven()
        state = ("time", "drive", *(f"{what}{k}" for what in self._published() for k in joints))
        command = tuple(f"{what}{k}" for what in self._commanded() for k in joints)
        super().__init__(DeviceSheet(name + self.mode, state, command, identity), robot, place, prefix, step_s)
        self._count = len(facts.joints)
        self._goal: Array = facts.home.copy()
        self._rate = np.zeros(self._count)
        self._is_motor = False
        self._data: Any = None
        self._rows: _Rows | None = None
        self.state[2 : 2 + self._count] = facts.home

    def _published(self) -> tuple[str, ...]:
        return ("q", "v", "t")

    def _commanded(self) -> tuple[str, ...]:
        return _COMMANDS[self.facts.drive]

    def _driven(self) -> str:
        """What a command consists of, as its identity says it."""
        return self.facts.drive

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Its joints as the world calls them, from the base on."""
        return tuple(self._prefix + name for name in self.facts.joints)

    @property
    def may_run_on(self) -> bool:
        """Whether it adds up speeds."""
        return self.facts.drive != "torque"

    @property
    def runs_on(self) -> bool:
        """Whether what it follows goes on between two commands."""
        return self.drive.mode is DriveMode.DRIVEN and self.may_run_on

    @property
    def posture(self) -> Array:
        """The joints as they stand (rad; m where one slides)."""
        posture: Array = self._data.qpos[self._q_at]
        return posture

    @property
    def is_away(self) -> bool:
        """Whether it does not stand at home."""
        return bool(np.abs(self.posture - self.facts.home).max() > _POSTURE)

    def bind(self, plant: Plant) -> None:
        """Find its joints and motors in a new plant, and make these what the device needs."""
        model, facts = plant.model, self.facts
        joints = [model.joint(self._prefix + name) for name in facts.joints]
        self._model, self._data = model, plant.data
        self._q_at = np.array([int(joint.qposadr[0]) for joint in joints])
        self._v_at = np.array([int(joint.dofadr[0]) for joint in joints])
        self._motors = np.array([int(model.actuator(self._prefix + name).id) for name in facts.actuators])
        self._bodies = _moved(model, int(joints[0].bodyid[0]))
        self._rows = _rows(plant.data, self._q_at, self._v_at, self._motors)
        limit(model, self._motors, facts.torque)
        self._be_motor(facts.drive == "torque" and self.drive.mode is DriveMode.DRIVEN)

    def follow(self, values: Sequence[float] | Array) -> bool:
        """As the device's kind says; what is not finite changes nothing."""
        if self._is_motor and self._rows is not None and type(values) is memoryview and math.isfinite(sum(values)):
            self._rows.signals[:] = values  # as nearly always: an arm by torques, while it is driven
            return True
        wanted = np.array(values, dtype=np.float64).reshape(-1, self._count)
        if not np.isfinite(wanted).all():
            return False
        match self.facts.drive:
            case "torque":
                if not self._is_motor:
                    self._be_motor(True)
                self._data.ctrl[self._motors] = wanted[0]
            case "position":
                np.clip(wanted[0], self.facts.lowest, self.facts.highest, out=self._goal)
                np.clip(wanted[1], -self.facts.speed, self.facts.speed, out=self._rate)
            case _:
                np.clip(wanted[0], -self.facts.speed, self.facts.speed, out=self._rate)
        return True

    def run_on(self) -> None:
        """The signals of one step, and what is followed in the next one where no command comes."""
        given = self.facts.gains
        self._data.ctrl[self._motors] = given.against_springs(self._goal) + given.lead * self._rate
        self._goal += self._rate * self._step_s
        np.clip(self._goal, self.facts.lowest, self.facts.highest, out=self._goal)

    def capture(self) -> None:
        """Stay where it was told to be; a torque device where it is."""
        if self.facts.drive == "torque":
            self._goal[:] = self.posture
        self._stay()

    def rest(self) -> None:
        """Stay where it is."""
        self._goal[:] = self.posture
        self._stay()

    def restart(self) -> None:
        """At home, at rest."""
        self._data.qpos[self._q_at] = self._goal[:] = self.facts.home
        self._data.qvel[self._v_at] = 0.0
        self._stay()

    def refresh(self, time: float) -> None:
        """Joint values, speeds, and what the drive does to them: its torque, and the weight that it bears."""
        count, state, data, rows = self._count, self.state, self._data, self._rows
        if rows is not None:
            row = self.row
            row[0] = time
            row[2 : 2 + count] = rows.places
            row[2 + count : 2 + 2 * count] = rows.speeds
            np.add(rows.driven, rows.borne, out=state[2 + 2 * count :])
            return
        state[0] = time
        state[2 : 2 + count] = data.qpos[self._q_at]
        state[2 + count : 2 + 2 * count] = data.qvel[self._v_at]
        state[2 + 2 * count :] = data.qfrc_actuator[self._v_at] + data.qfrc_gravcomp[self._v_at]

    def _stay(self) -> None:
        self._rate[:] = 0.0
        if self._is_motor:
            self._be_motor(False)
        self._data.ctrl[self._motors] = self.facts.gains.against_springs(self._goal)

    def _be_motor(self, is_motor: bool) -> None:
        """A motor bears no weight, a servo does."""
        self._is_motor = is_motor
        self._model.body_gravcomp[self._bodies] = 0.0 if is_motor else 1.0
        if is_motor:
            make_motor(self._model, self._motors)
        else:
            make_servo(self._model, self._motors, self.facts.gains)


class KinematicJointUnit(JointUnit):
    """The same joints without forces: they are where they are told to be, as far as limits and speeds allow."""

    mode: ClassVar[str] = FORCELESS

    def _published(self) -> tuple[str, ...]:
        return ("q",)

    def _commanded(self) -> tuple[str, ...]:
        return ("q",)

    def _driven(self) -> str:
        return WITHOUT_FORCES

    @property
    def runs_on(self) -> bool:
        """It does not."""
        return False

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Joint values; those beyond a limit are held at it."""
        wanted = np.array(values, dtype=np.float64).reshape(self._count)
        if not np.isfinite(wanted).all():
            return False
        np.clip(wanted, self.facts.lowest, self.facts.highest, out=self._goal)
        return True

    def capture(self) -> None:
        """Stay where it is."""
        self.rest()

    def move(self) -> None:
        """One step towards what was commanded last."""
        most = self.facts.speed * self._step_s
        here = self._data.qpos[self._q_at]
        self._data.qpos[self._q_at] = here + np.clip(self._goal - here, -most, most)

    def refresh(self, time: float) -> None:
        """Joint values."""
        self.state[0] = time
        self.state[2:] = self._data.qpos[self._q_at]


def _rows(data: Any, q_at: Array, v_at: Array, motors: Array) -> _Rows | None:
    """The views; None where something else stands in between."""
    if any((np.diff(numbers) != 1).any() for numbers in (q_at, v_at, motors)):
        return None
    q, v, m = (slice(int(numbers[0]), int(numbers[-1]) + 1) for numbers in (q_at, v_at, motors))
    return _Rows(
        row_of(data.qpos[q]), row_of(data.qvel[v]), data.qfrc_actuator[v], data.qfrc_gravcomp[v], row_of(data.ctrl[m])
    )


def _moved(model: Any, first: int) -> Array:
    """A body and all that it bears."""
    moved = {first}
    for body in range(first + 1, model.nbody):
        if int(model.body_parentid[body]) in moved:
            moved.add(body)
    return np.array(sorted(moved))
