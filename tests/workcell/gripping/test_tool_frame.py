"""The tool of an arm in a compiled world."""

import numpy as np
import pytest

from kit.worlds.grasping_cells import Cell
from onika.laws import reach
from onika.laws.arm_identity import arm_constants
from onika.laws.frames import pose_of_nine
from onika.workcell.gripping.tool_frame import ToolFrame


def test_it_is_where_the_constants_of_the_arm_say():  # R-X19
    cell = Cell()
    cell.go(0.4, -0.3, 0.05)
    (arm,) = cell.world._stands.arms()
    tool = ToolFrame(cell.world._plant, arm).pose()
    nine = reach.poses(arm_constants(arm.sheet.identity), [arm.posture.tolist()])[0]
    assert tool == pytest.approx(np.asarray(pose_of_nine(nine)), abs=1e-9)
