"""An arm as a device: torques come, joint angles go; it holds its posture by a servo of its own."""

import math
from collections.abc import Sequence
from typing import ClassVar

import numpy as np

from onika.laws.frames import Array
from onika.ring.device import DeviceSheet
from onika.workcell.layout import KINDS, STANDARD
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit, row_of


class ArmUnit(DeviceUnit):
    """An arm whose command is a torque for each joint (N m; N where it slides), whose state its angles (rad; m).

    `kind` is one of `layout.KINDS`; its body in the world and the device are called by it and the side.
    """

    mode: ClassVar[str] = ""
    """What stands behind its name, where it is another device than the arm with its motors."""
    command: ClassVar[str] = "tau"
    """What a command consists of."""

    def __init__(self, side: str, base: Array, kind: str = STANDARD) -> None:
        self.kind, self.robot = kind, KINDS[kind].robot
        joints = range(1, self.robot.NDOF + 1)
        name = f"{kind}_{side}"
        sheet = DeviceSheet(
            name + self.mode,
            ("time", "drive", *(f"q{k}" for k in joints)),
            tuple(f"{self.command}{k}" for k in joints),
            {"ROBOT": self.robot.ROBOT + self.mode, "BASE": tuple(base.ravel().tolist())},
        )
        super().__init__(sheet, side, holds=not self.mode)
        self._joints = [f"{name}.joint{k}" for k in joints]
        self._motors = [f"{name}.motor{k}" for k in joints]
        self._goal = self.robot.HOME.copy()
        self._pull, self._brake = np.zeros(self.robot.NDOF), np.zeros(self.robot.NDOF)
        self._q: Array = self.robot.HOME.copy()
        self.state[2:] = self._q
        self._angles = self.row[2:]

    def bind(self, plant: Plant) -> None:
        """Take the arrays of a new plant."""
        where, rate = plant.joints(self._joints)
        self._q, self._qd = plant.data.qpos[where], plant.data.qvel[rate]
        self._bias, self._signal = plant.data.qfrc_bias[rate], plant.data.ctrl[plant.signals(self._motors)]
        self._q_row, self._signal_row = row_of(self._q), row_of(self._signal)

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Torques; MuJoCo clips them to the motors' limits. Ones that are not finite are written over by holding."""
        try:
            self._signal_row[:] = values
        except TypeError:  # a list or tuple: no memory to copy from
            self._signal[:] = np.array(values, dtype=np.float64).reshape(self.robot.NDOF)
        return math.isfinite(sum(self._signal_row))

    def capture(self) -> None:
        """Hold the present posture."""
        self._goal[:] = self._q

    def hold(self) -> None:
        """tau = bias + KP (goal - q) - KD qd, clipped by the motors."""
        pull, brake = self._pull, self._brake
        np.subtract(self._goal, self._q, out=pull)
        pull *= self.robot.KP
        np.multiply(self._qd, self.robot.KD, out=brake)
        pull -= brake
        pull += self._bias
        self._signal[:] = pull

    @property
    def posture(self) -> Array:
        """The joints as they stand (rad; m where one slides)."""
        return self._q

    def restart(self) -> None:
        """Where it starts, at rest."""
        self._q[:] = self.robot.HOME
        self._qd[:] = 0.0
        self._goal[:] = self.robot.HOME

    def refresh(self, time: float) -> None:
        """Joint angles."""
        self.row[0] = time
        self._angles[:] = self._q_row
