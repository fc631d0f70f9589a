"""What a box that is carried touches: where it is taken from and where it is put down is meant, all else is not.

That it is put down there is seen only when the hand opens: until then it is remembered how it began.
"""

from dataclasses import dataclass

import numpy as np

from onika.laws.frames import Array

APART_M = 0.01
"""How far a box has left what it touched, where it only brushed it."""

DRAGGED_M = 0.03
"""How far a box may go along what it touches while it is lifted or settles."""

PUSHED_M = 0.006
"""How far what a box is put on may give way."""

_GONE_NS = 100_000_000


@dataclass(slots=True)
class Carriage:
    """A box in a hand that touches another thing.

    began_ns, poses, lit    when, and how everything stood then
    place, other            where the box was then, and the other one if it is a box
    is_lifted               whether it did so when it was taken
    """

    began_ns: int
    poses: bytes
    lit: tuple[str, ...]
    place: Array
    other: Array | None
    is_lifted: bool
    felt_ns: int
    is_told: bool = False
    is_over: bool = False

    def look(self, place: Array, other: Array | None, now_ns: int, *, touches: bool) -> bool:
        """Whether it is plain just now that this was not meant; `is_over` where there is no more to be learnt of it."""
        way = float(np.linalg.norm(place - self.place))
        is_wrong = False
        if touches:
            self.felt_ns = now_ns
            is_wrong = way > DRAGGED_M or self._gave_way(other)
        elif now_ns - self.felt_ns > _GONE_NS and way > APART_M:
            self.is_over = True
            is_wrong = not self.is_lifted
        is_new, self.is_told = is_wrong and not self.is_told, is_wrong or self.is_told
        return is_new

    def _gave_way(self, other: Array | None) -> bool:
        if self.other is None or other is None:
            return False
        return float(np.linalg.norm(other - self.other)) > PUSHED_M
