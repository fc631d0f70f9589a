"""A base of a robot from a file as a device: how fast it is to go comes, where it is and how fast it goes, goes.

A command is the speed forward, the speed to the left (m/s) and the rate of turning to the left (rad/s) of its body;
what it cannot do, as two wheels to the left, is left out. Between two commands it goes on; holding, it stands.
"""

import math
from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np

from onika.laws.frames import Array
from onika.ring.device import DeviceSheet
from onika.ring.drive import DriveMode
from onika.words.reason import Reason
from onika.workcell.composed import chain
from onika.workcell.composed.base_facts import BaseFacts
from onika.workcell.composed.robot_unit import FORCELESS, RobotUnit
from onika.workcell.composed.servo import limit, make_rate_servo
from onika.workcell.plant import Plant

STATE = ("time", "drive", "x", "y", "turn", "vx", "vy", "w")
"""Where it is in the world (m, rad), and the speeds that its drives measure in the frame of its body (m/s, rad/s)."""

COMMAND = ("vx", "vy", "w")
_AWAY = 0.02  # m or rad


class BaseUnit(RobotUnit):
    """A base by its name at a place of a world."""

    def __init__(self, name: str, facts: BaseFacts, robot: str, place: str, prefix: str, step_s: float) -> None:
        self.facts = facts
        sheet = DeviceSheet(name + self.mode, STATE, COMMAND, dict(facts.constants))
        super().__init__(sheet, robot, place, prefix, step_s)
        self._speed, self._twist = facts.speed, np.zeros(3)
        self._data: Any = None
        self._start = (0.0, 0.0, 0.0)

    @property
    def may_run_on(self) -> bool:
        """On slides its signals change as it turns."""
        return bool(self.facts.base.slides)

    @property
    def runs_on(self) -> bool:
        """Whether they change now."""
        return self.may_run_on and self.drive.mode is DriveMode.DRIVEN

    @property
    def is_away(self) -> bool:
        """Whether it does not stand where it began."""
        return bool(np.abs(np.subtract(self._place(), self._start)).max() > _AWAY)

    @property
    def away(self) -> Reason:
        """Where it stands."""
        x, y, turn = self._place()
        return Reason.of("workcell.base_away", base=self.sheet.name, x=x, y=y, degrees=math.degrees(turn))

    def bind(self, plant: Plant) -> None:
        """Find its joints and drives in a new plant; nothing bears its weight but the floor, or its slides."""
        model, facts = plant.model, self.facts
        joints = [model.joint(self._prefix + name) for name in facts.joints]
        moves = facts.base.wheels or facts.base.slides
        self._model, self._data = model, plant.data
        self._q_at = np.array([int(joint.qposadr[0]) for joint in joints])
        self._v_at = np.array([int(joint.dofadr[0]) for joint in joints])
        self._drives = np.array([int(model.actuator(self._prefix + name).id) for name in moves])
        self._body = int(model.body(self._prefix + facts.body).id)
        if facts.free:
            free = model.joint(self._prefix + facts.free)
            self._free_q, self._free_v = int(free.qposadr[0]), int(free.dofadr[0])
            root = int(model.body(self._prefix + facts.root).id)
            model.body_gravcomp[model.body_rootid == root] = 0.0
        self._start = _flat(chain.at_zero(model, ()), self._body)
        limit(model, self._drives, facts.torque)
        make_rate_servo(model, self._drives, facts.gains)
        self._signal()

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Go so fast, within its highest speeds."""
        wanted = np.array(values, dtype=np.float64)
        if not np.isfinite(wanted).all():
            return False
        np.clip(wanted, -self._speed, self._speed, out=self._twist)
        self._signal()
        return True

    def run_on(self) -> None:
        """The signals of one step, as it is turned now."""
        self._signal()

    def capture(self) -> None:
        """Stand."""
        self._twist[:] = 0.0
        self._signal()

    def rest(self) -> None:
        """Stand."""
        self.capture()

    def restart(self) -> None:
        """Where it began, at rest."""
        data, model = self._data, self._model
        if self.facts.free:
            data.qpos[self._free_q : self._free_q + 7] = model.qpos0[self._free_q : self._free_q + 7]
            data.qvel[self._free_v : self._free_v + 6] = 0.0
        data.qpos[self._q_at] = model.qpos0[self._q_at]
        data.qvel[self._v_at] = 0.0
        self.rest()

    def refresh(self, time: float) -> None:
        """Where it is, and how fast its drives go."""
        state = self.state
        state[0] = time
        state[2:5] = self._place()
        state[5:8] = self._measured()

    def _place(self) -> tuple[float, float, float]:
        return _flat(self._data, self._body)

    def _measured(self) -> Array:
        """The speeds of its body as its drives tell them."""
        rates = self._data.qvel[self._v_at] * self.facts.turned
        base = self.facts.base
        if base.wheels:
            left, right = rates * base.radius
            return np.array((0.5 * (left + right), 0.0, (right - left) / base.track))
        return np.array((*_turned(-self._heading(), rates[0], rates[1]), rates[2]))

    def _signal(self) -> None:
        self._data.ctrl[self._drives] = self._rates(self._twist)

    def _rates(self, twist: Array) -> Array:
        """How fast each of its joints goes with these speeds of its body."""
        forward, left, turning = twist.tolist()
        base = self.facts.base
        if base.wheels:
            aside = 0.5 * turning * base.track
            rates = np.array((forward - aside, forward + aside)) / base.radius
        else:
            rates = np.array((*_turned(self._heading(), forward, left), turning))
        return np.asarray(rates * self.facts.turned)

    def _heading(self) -> float:
        """How far the turn of a base on slides is turned."""
        return float(self._data.qpos[self._q_at[2]] * self.facts.turned[2])


class KinematicBaseUnit(BaseUnit):
    """The same base without forces: it goes exactly as it is told."""

    mode: ClassVar[str] = FORCELESS

    @property
    def runs_on(self) -> bool:
        """It does not."""
        return False

    def move(self) -> None:
        """One step as commanded last."""
        data, step = self._data, self._step_s
        rates = self._rates(self._twist)
        if self.facts.free:
            turn = self._twist[2] * step
            x, y, w = self._free_q, self._free_q + 1, self._free_q + 3
            heading = self._place()[2] + 0.5 * turn
            shift = _turned(heading, self._twist[0], self._twist[1])
            data.qpos[x] += step * shift[0]
            data.qpos[y] += step * shift[1]
            data.qpos[w : w + 4] = _about_z(turn, data.qpos[w : w + 4])
        data.qpos[self._q_at] += step * rates

    def _measured(self) -> Array:
        return self._twist


def _flat(data: Any, body: int) -> tuple[float, float, float]:
    """Where a body is on the floor, and where it heads."""
    x, y, _ = data.xpos[body].tolist()
    rotation = data.xmat[body]
    return x, y, math.atan2(float(rotation[3]), float(rotation[0]))


def _turned(angle: float, x: float, y: float) -> tuple[float, float]:
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y


def _about_z(angle: float, quaternion: Array) -> Array:
    """A quaternion (w, x, y, z) turned about z of the world."""
    c, s = math.cos(0.5 * angle), math.sin(0.5 * angle)
    w, x, y, z = quaternion.tolist()
    return np.array((c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w))
