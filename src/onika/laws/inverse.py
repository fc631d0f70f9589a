"""Inverse kinematics of any arm: the closed form where its table allows one, damped least squares otherwise."""

from typing import Protocol

import numpy as np

from onika.laws.chain import kinds_of
from onika.laws.damped import DampedInverse
from onika.laws.frames import Array, Numbers, as_array
from onika.laws.puma_inverse import PumaInverse, is_puma_family
from onika.laws.scara_inverse import ScaraInverse, is_scara_family
from onika.laws.sentence import LawSentence


class Inverse(Protocol):
    """Joint angles of a pose."""

    def nearest(self, pose: Array, q_near: Numbers) -> Array | LawSentence:
        """The solution double[n] within limits that is nearest to `q_near`, or the reason why there is none.

        `pose` double[4,4] is the tool in the world. Nearest is the smallest sum of squared differences.
        """
        ...


def inverse_for(
    dh: Numbers, base: Numbers | None, tool: Numbers | None, qmin: Numbers, qmax: Numbers, kind: Numbers | None = None
) -> Inverse:
    """The inverse of an arm given by constants (units and kinds as in `Arm`); `qmin`, `qmax` double[n]."""
    n = np.size(dh) // 4
    table = as_array(dh, (n, 4))
    kinds = as_array(kinds_of(table) if kind is None else kind, (n,))
    lows, highs = as_array(qmin, (n,)), as_array(qmax, (n,))
    frames = (
        as_array(np.eye(4) if base is None else base, (4, 4)),
        as_array(np.eye(4) if tool is None else tool, (4, 4)),
    )
    if is_puma_family(table, kinds):
        return PumaInverse(table, *frames, lows, highs)
    if is_scara_family(table, kinds):
        return ScaraInverse(table, *frames, lows, highs)
    return DampedInverse(table, *frames, lows, highs, kinds)
