"""Inverse kinematics of any arm: the closed form where its joints allow one, damped least squares otherwise."""

from typing import Protocol

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.damped import STARTS, DampedInverse
from onika.laws.family_table import FamilyTable
from onika.laws.frames import Array, Numbers, as_array, inverse_pose
from onika.laws.puma_family import puma_table
from onika.laws.puma_inverse import PumaInverse
from onika.laws.scara_family import scara_table
from onika.laws.scara_inverse import ScaraInverse
from onika.laws.screws import Parents, parents_of_chain
from onika.laws.sentence import LawSentence
from onika.laws.textbook import serial_arm


class Inverse(Protocol):
    """Joint angles of a pose."""

    def nearest(self, pose: Array, q_near: Numbers) -> Array | LawSentence:
        """The solution double[n] within limits that is nearest to `q_near`, or the reason why there is none.

        `pose` double[4,4] is the tool in the world. Nearest is the smallest sum of squared differences.
        """
        ...


def inverse_for(
    screw: Numbers,
    base: Numbers | None,
    tool: Numbers | None,
    qmin: Numbers,
    qmax: Numbers,
    parent: Numbers | Parents | None = None,
    starts: int = STARTS,
) -> Inverse:
    """The inverse of an arm given by constants (as in `ArmModel`); `qmin`, `qmax` double[n], infinite: no limit.

    `starts`: how hard a solution far from the last one is looked for where there is no closed form; 0: not at all.
    """
    return inverse_of(ArmModel(screw, parent=parent, base=base, tool=tool), qmin, qmax, starts)


def inverse_of(arm: ArmModel, qmin: Numbers, qmax: Numbers, starts: int = STARTS) -> Inverse:
    """The inverse of an arm; `qmin`, `qmax` double[n], infinite: no limit; `starts` as above."""
    low, high = as_array(qmin, (arm.n,)), as_array(qmax, (arm.n,))
    if not np.array_equal(arm.parent, parents_of_chain(arm.n)):
        return DampedInverse(arm, low, high, starts)
    for table_of, law in ((puma_table, PumaInverse), (scara_table, ScaraInverse)):
        table = table_of(arm.screw)
        if table is not None:
            return law(table.dh, arm.base @ table.first, _tool(table, arm.tool), low, high)
    return DampedInverse(arm, low, high, starts)


def serial_inverse(
    dh: Numbers, base: Numbers | None, tool: Numbers | None, qmin: Numbers, qmax: Numbers, kind: Numbers | None = None
) -> Inverse:
    """The inverse of the arm of a textbook's table (`onika.laws.textbook`); `tool` in its last frame."""
    return inverse_of(serial_arm(dh, base=base, tool=tool, kind=kind), qmin, qmax)


def _tool(table: FamilyTable, tool: Array) -> Array:
    """The tool in the last frame of a table; an unturned one to the last digit, as its closed form is quicker then."""
    pose = inverse_pose(table.last) @ tool
    if np.allclose(pose[:3, :3], np.eye(3), rtol=0.0, atol=1e-15):
        pose[:3, :3] = np.eye(3)
    return pose
