"""A device of a world from within: its sheet, its drive, its claim and the doubles it publishes.

Units stay the same when the world is compiled anew; `bind` gives them the arrays of the new plant.
"""

import math
from collections.abc import Sequence

import numpy as np

from onika.laws import puma560
from onika.laws.frames import Array
from onika.ring.device import DeviceSheet, Drive
from onika.workcell.box import SIGNS
from onika.workcell.circuit import CONTACTS, Circuit
from onika.workcell.drive import DriveUnit
from onika.workcell.gripper import CLOSED_M
from onika.workcell.plant import Plant

NOBODY = -1
"""The epoch of a device that is not claimed."""


class Unit:
    """What all devices have; a device does what is said here unless it says otherwise.

    `side` is the arm it belongs to ("" for none), `holds` says that holding needs a servo at each step.
    """

    def __init__(self, sheet: DeviceSheet, side: str = "", holds: bool = False) -> None:
        self.sheet, self.side, self.holds = sheet, side, holds
        self.drive = DriveUnit()
        self.epoch = NOBODY  # who claims it
        self.follows = NOBODY  # the same while it is driven: whom it follows
        self.state: Array = np.zeros(len(sheet.state))
        self.state[1] = self.drive.shown
        self.row = memoryview(self.state)  # short rows copy three times as fast through memoryviews as through arrays

    def bind(self, plant: Plant) -> None:
        """Take the arrays of a new plant."""
        raise NotImplementedError

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Follow these values from the next step on; False, and nothing of them done then, if any is not finite."""
        raise NotImplementedError

    def capture(self) -> None:
        """Hold what is there now; by itself a device keeps its last signals."""

    def hold(self) -> None:
        """Write the signals of holding for one step."""

    def sense(self) -> None:
        """Publish what touch sensors feel, every 10 ms, after `Plant.sense`."""

    def restart(self) -> None:
        """Go to the posture of start, at rest."""

    def refresh(self, time: float) -> None:
        """Publish: write `state` anew, at `time` seconds."""
        self.row[0] = time


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
        self._q_row, self._signal_row = memoryview(self._q), memoryview(self._signal)

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Torques; MuJoCo clips them to the motors' limits. Ones that are not finite are written over by holding."""
        try:
            self._signal_row[:] = values  # type: ignore[assignment]
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


class GripperUnit(Unit):
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
        self._rows = tuple(memoryview(array) for array in (self.state, self._q, self._qd, self._pads))

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


class LampUnit(Unit):
    """The lamp, which only publishes: the six contacts of its circuit, judged every 10 ms."""

    def __init__(self) -> None:
        names = tuple(f"contact{k}" for k in range(1, CONTACTS + 1))
        super().__init__(DeviceSheet("lamp", ("time", "drive", *names), (), {"BOXES": " ".join(SIGNS)}))
        self.state[1] = Drive.DRIVEN  # it has no drive that could hold or trip
        self.flags = self.state[2:]
        self._circuit: Circuit

    def bind(self, plant: Plant) -> None:
        """Find the circuit in a new plant."""
        self._circuit = Circuit(plant)

    @property
    def lit(self) -> bool:
        """Whether all contacts are closed."""
        return bool(self.flags.all())

    def sense(self) -> None:
        """The contacts of the last step."""
        self._circuit.scan(self.flags)

    def restart(self) -> None:
        """Dark."""
        self.flags[:] = 0.0
