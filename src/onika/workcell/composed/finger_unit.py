"""A gripper of a robot from a file as a device: how far open, and how hard, comes; opening, speed and force go."""

from collections.abc import Sequence
from typing import Any, ClassVar, Protocol

import numpy as np
import numpy.typing as npt

from onika.laws.frames import Array
from onika.ring.device import DeviceSheet
from onika.workcell.composed.gripper_facts import GripperFacts
from onika.workcell.composed.robot_unit import EITHER, RobotUnit
from onika.workcell.composed.servo import finger_gains, make_servo
from onika.workcell.plant import Plant
from onika.workcell.unit import row_of

_SPEED = 0.2
"""How fast motors are led to open or close (m/s)."""


class MovedFingers(Protocol):
    """How far a gripper is open (m), how fast it opens (m/s), and what it presses with (N), where no forces move it."""

    @property
    def opening(self) -> float:
        """In metres."""

    @property
    def speed(self) -> float:
        """In metres a second."""

    @property
    def force(self) -> float:
        """In newtons."""


class FingerUnit(RobotUnit):
    """A gripper at a place of a world. Holding, it keeps its last command: what it holds stays held.

    A command is the opening (m) and the force of the fingers (N); a force of 0 or less is as much as there is. Motors
    are led to openings at an even speed: by themselves they only push, and what they slam against gives way.
    """

    mode: ClassVar[str] = EITHER
    is_stopped: ClassVar[bool] = False

    def __init__(self, name: str, facts: GripperFacts, robot: str, place: str, prefix: str, step_s: float) -> None:
        self.facts = facts
        state = ("time", "drive", "opening", "speed", "force")
        sheet = DeviceSheet(name, state, self._commanded(), dict(facts.constants))
        super().__init__(sheet, robot, place, prefix, step_s)
        self._goal = (facts.gripper.closed[1], 0.0)
        self._narrow, self._short = facts.gripper.closed[1], facts.lengths[0]  # read at every step
        self.state[2] = self._narrow
        self._data: Any = None
        self._motors: npt.NDArray[np.int64] = np.zeros(0, dtype=np.int64)
        self._wanted: Array = np.zeros(0)
        self._is_there = True
        self.moved_by: MovedFingers | None = None
        """What moves it where there are no forces."""

    @property
    def aim(self) -> float:
        """How far open it is told to be (m)."""
        return min(max(self._goal[0], self.facts.gripper.closed[1]), self.facts.gripper.open[1])

    @property
    def pressing(self) -> float:
        """What its fingers are told to press with (N)."""
        return min(self._goal[1], self.facts.force) if self._goal[1] > 0.0 else self.facts.force

    @property
    def motors(self) -> npt.NDArray[np.int64]:
        """The numbers of its actuators."""
        return self._motors

    @property
    def felt_at(self) -> tuple[int, ...]:
        """Where the numbers of its sensors stand."""
        return tuple(self._felt.tolist())

    def _commanded(self) -> tuple[str, ...]:
        return ("opening", "force")

    def bind(self, plant: Plant) -> None:
        """Find its actuators and sensors in a new plant."""
        model, gripper = plant.model, self.facts.gripper
        self.moved_by = None
        self._model, self._data = model, plant.data
        self._motors = np.array([int(model.actuator(self._prefix + name).id) for name in gripper.moves])
        sensors = [model.sensor(self._prefix + name) for name in gripper.force]
        self._felt = np.array([int(sensor.adr[0]) for sensor in sensors], dtype=int)
        self._is_felt = bool(sensors)
        self._pads = tuple(row_of(plant.data.sensordata[at : at + 1]) for at in self.felt_at)
        self._lead(plant)
        first = int(self._motors[0])
        data = plant.data
        self._length = row_of(data.actuator_length[first : first + 1])
        self._speed = row_of(data.actuator_velocity[first : first + 1])
        self._signal()

    def signals(self, opening: float) -> Array:
        """What each of its actuators is told where it is to be so far open (m)."""
        (open_signal, open_m), (closed_signal, closed_m) = self.facts.gripper.open, self.facts.gripper.closed
        share = min(max((opening - closed_m) / (open_m - closed_m), 0.0), 1.0)
        ends = [way or (closed_signal, open_signal) for way in self.facts.ways]
        return np.array([closed + share * (opened - closed) for closed, opened in ends])

    @property
    def may_run_on(self) -> bool:
        """Whether its motors are led."""
        return any(way is not None for way in self.facts.ways)

    @property
    def runs_on(self) -> bool:
        """They are, whatever its drive does."""
        return self.may_run_on

    def run_on(self) -> None:
        """A step towards the opening that is wanted."""
        if not self._is_there:
            gap = self._wanted - self._data.ctrl[self._motors]
            self._data.ctrl[self._motors] += np.clip(gap, -self._steps, self._steps)
            self._is_there = bool((np.abs(gap) <= self._steps).all())

    def _lead(self, plant: Plant) -> None:
        """Let its motors go to lengths: what only pushes has no opening between both ends, and no force there."""
        led = np.array([way is not None for way in self.facts.ways])
        motors = self._motors[led]
        if motors.size:
            make_servo(plant.model, motors, finger_gains(plant.model, motors))
        ways = np.array([abs(way[1] - way[0]) if way is not None else np.inf for way in self.facts.ways])
        self._steps = ways * (_SPEED * self._step_s / (self.facts.gripper.open[1] - self.facts.gripper.closed[1]))

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Go as far apart, and press as hard, as told."""
        opening, force = (float(value) for value in values)
        if not np.isfinite((opening, force)).all():
            return False
        self._aim(opening, force)
        return True

    def restart(self) -> None:
        """Closed, with all its force, under pressure where it has a cylinder."""
        self._goal = (self.facts.gripper.closed[1], 0.0)
        self._signal()
        self._data.ctrl[self._motors] = self._wanted
        for motor in self._motors.tolist():
            at = int(self._model.actuator_actadr[motor])
            if at >= 0:
                self._data.act[at] = self._data.ctrl[motor]

    def refresh(self, time: float) -> None:
        """Opening (m), its speed (m/s) and, where no sensor feels it, the force of the actuators (N)."""
        row, leverage, moved = self.row, self.facts.leverage, self.moved_by
        row[0] = time
        if moved is not None:
            row[2], row[3], row[4] = moved.opening, moved.speed, moved.force
            return
        row[2] = self._narrow + (self._length[0] - self._short) / leverage
        row[3] = self._speed[0] / leverage
        if not self._is_felt:
            row[4] = abs(float(self._data.actuator_force[self._motors].sum()) * leverage)

    def sense(self) -> None:
        """The mean force that its sensors feel (N)."""
        if self._is_felt and self.moved_by is None:
            self.row[4] = sum(row[0] for row in self._pads) / len(self._pads)

    def _aim(self, opening: float, force: float) -> None:
        if (opening, force) != self._goal:
            self._goal = opening, force
            self._signal()

    def _signal(self) -> None:
        self._wanted, self._is_there = self.signals(self._goal[0]), False
        if not self.may_run_on:
            self._data.ctrl[self._motors] = self._wanted
        highest = self.pressing / (abs(self.facts.leverage) * len(self._motors))
        self._model.actuator_forcelimited[self._motors] = 1
        self._model.actuator_forcerange[self._motors] = (-highest, highest)
