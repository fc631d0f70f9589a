"""An arm as a device: six torques come, six joint angles go; it holds its posture by a servo of its own."""

import math
from collections.abc import Sequence

import numpy as np

from onika.laws import puma560
from onika.laws.frames import Array
from onika.ring.device import DeviceSheet
from onika.workcell.plant import Plant
from onika.workcell.unit import Unit, row_of


class ArmUnit(Unit):
    """A PUMA 560 whose command is six torques (N m) and whose state is six joint angles (rad)."""

    def __init__(self, side: str, base: Array) -> None:
        joints = range(1, puma560.NDOF + 1)
        name = f"arm_{side}"
        sheet = DeviceSheet(
            name,
            ("time", "drive", *(f"q{k}" for k in joints)),
            tuple(f"tau{k}" for k in joints),
            {"ROBOT": puma560.ROBOT, "BASE": tuple(base.ravel().tolist())},
        )
        super().__init__(sheet, side, holds=True)
        self._joints = [f"{name}.joint{k}" for k in joints]
        self._motors = [f"{name}.motor{k}" for k in joints]
        self._goal = puma560.HOME.copy()
        self._pull, self._brake = np.zeros(puma560.NDOF), np.zeros(puma560.NDOF)
        self._q: Array = puma560.HOME.copy()
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
            self._signal[:] = np.array(values, dtype=np.float64).reshape(puma560.NDOF)
        return math.isfinite(sum(self._signal_row))

    def capture(self) -> None:
        """Hold the present posture."""
        self._goal[:] = self._q

    def hold(self) -> None:
        """tau = bias + KP (goal - q) - KD qd, clipped by the motors."""
        pull, brake = self._pull, self._brake
        np.subtract(self._goal, self._q, out=pull)
        pull *= puma560.KP
        np.multiply(self._qd, puma560.KD, out=brake)
        pull -= brake
        pull += self._bias
        self._signal[:] = pull

    def restart(self) -> None:
        """Straight up and at rest."""
        self._q[:] = puma560.HOME
        self._qd[:] = 0.0
        self._goal[:] = puma560.HOME

    def refresh(self, time: float) -> None:
        """Joint angles."""
        self.row[0] = time
        self._angles[:] = self._q_row
