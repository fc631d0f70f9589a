"""An arm of a file that takes torques and holds by gains of its own, as a device (requirement X19).

Holding: tau = bias + KP (goal - q) - KD qd, at each step, limited as the motors are. It publishes joint values alone.
"""

import math
from collections.abc import Sequence

import numpy as np

from onika.laws.frames import Array
from onika.model.robot import Numbers
from onika.workcell.composed.joint_facts import JointFacts
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.plant import Plant
from onika.workcell.unit import row_of


class HeldJointUnit(JointUnit):
    """A chain whose joints stand beside each other in the world's model, and so do their motors."""

    def __init__(
        self, name: str, facts: JointFacts, robot: str, place: str, prefix: str, step_s: float, base: Numbers
    ) -> None:
        super().__init__(name, facts, robot, place, prefix, step_s, base)
        self.holds = True
        self._stiffness, self._damping = facts.held_by or (np.zeros(self._count), np.zeros(self._count))
        self._pull, self._brake = np.zeros(self._count), np.zeros(self._count)
        self._angles = self.row[2:]

    def _published(self) -> tuple[str, ...]:
        return ("q",)

    def bind(self, plant: Plant) -> None:
        """Take the arrays of a new plant."""
        super().bind(plant)
        where, rate = plant.joints([*self.joint_names])
        self._q, self._qd = plant.data.qpos[where], plant.data.qvel[rate]
        self._bias = plant.data.qfrc_bias[rate]
        self._signal = plant.data.ctrl[plant.signals([self._prefix + name for name in self.facts.actuators])]
        self._q_row, self._signal_row = row_of(self._q), row_of(self._signal)
        self._be_motor(True)

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Torques; ones that are not finite are written over by holding."""
        try:
            self._signal_row[:] = values
        except TypeError:  # a list or tuple: no memory to copy from
            self._signal[:] = np.array(values, dtype=np.float64).reshape(self._count)
        return math.isfinite(sum(self._signal_row))

    def hold(self) -> None:
        """The torques of holding for one step."""
        pull, brake = self._pull, self._brake
        np.subtract(self._goal, self._q, out=pull)
        pull *= self._stiffness
        np.multiply(self._qd, self._damping, out=brake)
        pull -= brake
        pull += self._bias
        self._signal[:] = pull

    def capture(self) -> None:
        """Hold the present posture."""
        self._goal[:] = self._q

    def rest(self) -> None:
        """Stay where it is."""
        self._goal[:] = self._q

    def restart(self) -> None:
        """At home, at rest."""
        self._q[:] = self._goal[:] = self.facts.home
        self._qd[:] = 0.0

    def refresh(self, time: float) -> None:
        """Joint values."""
        self.row[0] = time
        self._angles[:] = self._q_row
