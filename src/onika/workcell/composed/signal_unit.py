"""A gripper of a file that one signal opens or closes, as compressed air does, as a device (requirement X19)."""

import math
from collections.abc import Sequence

from onika.laws.frames import Array
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.composed.gripper_facts import GripperFacts


class SignalUnit(FingerUnit):
    """A gripper whose command is one number: above 0 it opens, below 0 it closes, 0 changes nothing."""

    def __init__(self, name: str, facts: GripperFacts, robot: str, place: str, prefix: str, step_s: float) -> None:
        super().__init__(name, facts, robot, place, prefix, step_s)
        self._sense = -1.0
        self._wide = facts.gripper.open[1]

    def _commanded(self) -> tuple[str, ...]:
        return ("signal",)

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Open or close, with all its force."""
        (signal,) = values
        if not -math.inf < signal < math.inf:
            return False
        if signal * self._sense < 0.0:
            self._sense = -self._sense
            self._aim(self._wide if signal > 0.0 else self._narrow, 0.0)
        return True

    def restart(self) -> None:
        """Closed, with all its force."""
        self._sense = -1.0
        super().restart()
