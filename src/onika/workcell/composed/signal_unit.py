"""A gripper of a file that one signal opens or closes, as compressed air does, as a device (requirement X19)."""

import math
from collections.abc import Sequence

from onika.laws.frames import Array
from onika.workcell.composed.finger_unit import FingerUnit


class SignalUnit(FingerUnit):
    """A gripper whose command is one number: above 0 it opens, below 0 it closes, 0 changes nothing."""

    def _commanded(self) -> tuple[str, ...]:
        return ("signal",)

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Open or close, with all its force."""
        (signal,) = values
        if not -math.inf < signal < math.inf:
            return False
        if signal != 0.0:
            gripper = self.facts.gripper
            self._aim((gripper.open if signal > 0.0 else gripper.closed)[1], 0.0)
        return True
