"""An arm without forces as a device: joint angles come, joint angles go; it is where it is told to be (law 18)."""

import math
from collections.abc import Sequence
from typing import ClassVar

import numpy as np

from onika.laws.frames import Array
from onika.workcell.arm_unit import ArmUnit
from onika.workcell.layout import STANDARD
from onika.workcell.part import STEP_S


class KinematicUnit(ArmUnit):
    """The same arm in the kinematic mode: its command is an angle for each joint (rad; m where it slides).

    It follows exactly as long as the joints' limits and highest speeds allow, and as far as they do where not.
    """

    mode: ClassVar[str] = "_kin"
    command: ClassVar[str] = "q"

    def __init__(self, side: str, base: Array, kind: str = STANDARD) -> None:
        super().__init__(side, base, kind)
        self._most: Array = self.robot.QDMAX * STEP_S
        self._least: Array = -self._most
        self._wanted: Array = self._goal.copy()

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Angles; those beyond a limit are held at it."""
        wanted = self._wanted
        wanted[:] = np.array(values, dtype=np.float64).reshape(self.robot.NDOF)
        if not math.isfinite(sum(wanted.tolist())):
            return False
        np.maximum(np.minimum(wanted, self.robot.QMAX, out=self._goal), self.robot.QMIN, out=self._goal)
        return True

    def move(self) -> None:
        """One step towards what was commanded last."""
        way = np.subtract(self._goal, self._q, out=self._pull)
        np.maximum(np.minimum(way, self._most, out=way), self._least, out=way)
        self._q += way
