"""The box assembly of chapter 6 by hand: a whole control system in one loop moves a world, with no runtime between.

world = boxes_world(seed)
assembler = Assembler(world)
assembler.assemble()
"""

import math
from collections.abc import Callable, Collection
from typing import Any

import numpy as np

from kit.worlds.box_cells import LAYOUT_M, TOP_M
from onika.laws import puma560
from onika.laws.filter import Derivative
from onika.laws.frames import Array, pose_of_nine
from onika.laws.inverse import serial_inverse
from onika.laws.path import StraightLine, joint_duration, quintic
from onika.laws.textbook import serial_arm
from onika.ring.device import DeviceOrder
from onika.workcell.cell.file_world import FileWorld

DT = 0.002
GRASP_M = TOP_M + 0.0254
_ABOVE_M = -0.125
_LIFTED = [0.0, -0.7, 2.9, 0.0, 1.0, 1.36]


class Assembler:
    """One arm with its hand: gravity model, joint servo, path, straight line and inverse kinematics."""

    def __init__(self, world: FileWorld, side: str = "left", epoch: int = 1) -> None:
        self.world, self.epoch = world, epoch
        self.arm, self.hand = f"arm_{side}", f"gripper_{side}"
        sheet = world.claim(self.arm, epoch)
        world.claim(self.hand, epoch)
        base = np.reshape(sheet.identity["BASE"], (4, 4))
        self._law = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD, base, puma560.TOOL)
        self._inverse = serial_inverse(puma560.DH, base, puma560.TOOL, puma560.QMIN, puma560.QMAX)
        self.q = world.state(self.arm)[2:]
        self.reference, self.speed = self.q.copy(), np.zeros(6)
        self._derivative = Derivative(6, DT, 60.0)
        self._derivative.reset(self.q)
        self._signal = -1.0
        self.worst = 0.0
        """The largest angle between the arm and its reference."""

    def command(self) -> None:
        """One command to arm and hand."""
        measured = self._derivative.update(self.q)
        torque = self._law.bias(self.q, measured) + self._law.viscous * self.speed
        torque += puma560.KP * (self.reference - self.q) + puma560.KD * (self.speed - measured)
        self.world.command(self.arm, self.epoch, DeviceOrder.DRIVE, torque)
        self.world.command(self.hand, self.epoch, DeviceOrder.DRIVE, [self._signal])

    def tick(self) -> None:
        """A command, and a step of the world."""
        self.command()
        self.world.step(self.world.now_ns + self.world.step_ns)
        self.worst = max(self.worst, float(np.abs(self.reference - self.q).max()))

    def turn(self, q: Array) -> None:
        """Along a path of fifth order to these joint angles."""
        start = self.reference.copy()
        duration = joint_duration(start, q, 0.6 * puma560.QDMAX)
        for k in range(math.ceil(duration / DT)):
            value, rate = quintic((k + 1) * DT, duration)
            self.reference[:], self.speed[:] = start + value * (q - start), rate * (q - start)
            self.tick()
        self._settle()

    def go(self, pose: Array) -> None:
        """Straight to a pose."""
        line = StraightLine(self._law.forward(self.reference), pose)
        duration = line.duration(0.3, 1.0)
        for k in range(math.ceil(duration / DT)):
            q = self._near(line.at(quintic((k + 1) * DT, duration)[0]), self.reference)
            self.speed[:], self.reference[:] = (q - self.reference) / DT, q
            self.tick()
        self._settle()

    def grip(self, signal: float) -> None:
        """Open (1) or close (-1) the hand."""
        self._signal = signal
        for _ in range(200):
            self.tick()

    def above(self, sign: str) -> Array:
        """The joint angles well above a place of the layout."""
        near = _LIFTED if self.arm == "arm_left" else [*_LIFTED[:5], -1.78]
        return self._near(pose_at(*LAYOUT_M[sign], _ABOVE_M), np.array(near))

    def actions(self) -> list[tuple[Callable[[Any], None], Any]]:
        """The twenty-four actions of chapter 6, each a verb and what it is done with."""
        waves = LAYOUT_M["waves"]
        rows: list[tuple[Callable[[Any], None], Any]] = [(self.grip, 1.0)]
        for level, sign in enumerate(("triangle", "square", "cross"), 1):
            rows += [
                (self.turn, self.above(sign)),
                (self.go, pose_at(*LAYOUT_M[sign], GRASP_M)),
                (self.grip, -1.0),
                (self.turn, self.above(sign)),
                (self.turn, self.above("waves")),
                (self.go, pose_at(*waves, TOP_M + 0.0508 * (level + 0.5) + 0.0008)),
                (self.grip, 1.0),
                (self.turn, self.above("waves")),
            ]
        return rows[:-1]

    def assemble(self, left_out: Collection[int] = ()) -> None:
        """All of them in order, but for these."""
        for number, (verb, argument) in enumerate(self.actions()):
            if number not in left_out:
                verb(argument)

    def _settle(self) -> None:
        self.speed[:] = 0.0
        for _ in range(250):
            self.tick()
            if np.abs(self.reference - self.q).max() < 1e-3 and np.abs(self._derivative.value).max() < 0.01:
                return

    def _near(self, pose: Array, q: Array) -> Array:
        nearest = self._inverse.nearest(pose, q)
        if isinstance(nearest, str):
            raise ValueError(f"expected a pose within reach, found one that is {nearest}")
        return nearest


def pose_at(x: float, y: float, z: float) -> Array:
    return pose_of_nine([0.0, 0.0, -1.0, 0.0, 1.0, 0.0, x, y, z])
