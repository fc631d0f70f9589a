"""A hand as a device: one number opens or closes it; its valves keep the last signal, so pressure stays in hold."""

import math
from collections.abc import Sequence

import numpy as np

from onika.laws.frames import Array
from onika.ring.device import DeviceSheet
from onika.workcell.gripper import CLOSED_M
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit, row_of


class GripperUnit(DeviceUnit):
    """A hand whose command is one number (above 0 open, below 0 close) and whose valves keep the last signal."""

    def __init__(self, side: str) -> None:
        name = f"gripper_{side}"
        sheet = DeviceSheet(
            name,
            ("time", "drive", "opening", "speed", "force"),
            ("signal",),
            {"ROBOT": "gripper", "ARM": f"arm_{side}"},
        )
        super().__init__(sheet, side)
        self._names = [[f"{name}.{part}{k}" for k in (1, 2)] for part in ("finger", "valve", "touch")]
        self._q: Array = np.zeros(2)
        self._sense = -1.0
        self.state[2] = CLOSED_M

    def bind(self, plant: Plant) -> None:
        """Take the arrays of a new plant."""
        fingers, valves, pads = self._names
        where, rate = plant.joints(fingers)
        self._q, self._qd = plant.data.qpos[where], plant.data.qvel[rate]
        self._signal, self._pads = plant.data.ctrl[plant.signals(valves)], plant.data.sensordata[plant.sensors(pads)]
        first = int(plant.model.actuator(valves[0]).actadr[0])
        self._air = plant.data.act[first : first + 2]
        self._rows = tuple(row_of(array) for array in (self.state, self._q, self._qd, self._pads))

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Open or close; 0 changes nothing."""
        (signal,) = values
        if not -math.inf < signal < math.inf:
            return False
        if signal * self._sense < 0.0:
            self._sense = -self._sense
            self._signal[:] = self._sense
        return True

    def restart(self) -> None:
        """Closed, under pressure, at rest."""
        self._q[:] = self._qd[:] = 0.0
        self._sense = -1.0
        self._signal[:] = self._air[:] = -1.0

    def refresh(self, time: float) -> None:
        """Opening between the pads (m) and its speed (m/s)."""
        state, q, qd, _ = self._rows
        state[0] = time
        state[2] = CLOSED_M + q[0] + q[1]
        state[3] = qd[0] + qd[1]

    def sense(self) -> None:
        """The force on a pad (N), mean of both."""
        state, _, _, pads = self._rows
        state[4] = 0.5 * (pads[0] + pads[1])
