from dataclasses import replace

import mujoco
import numpy as np
import pytest

from kit.worlds.file_cells import ARM, files_of
from onika.laws import reach
from onika.laws.arm_identity import arm_constants
from onika.store.shipped import shipped
from onika.workcell.composed.robot_model import at_home, robot_model
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.drafting.draft_motion import beside_home, lowest_point, seconds_between, straight_line

MODEL = mujoco.MjModel.from_xml_string(ARM)


def elbow():
    sources = SourceTexts(files_of())
    return robot_model(sources, sources.robots["elbow"], [])


def facts():
    return elbow().joints[0]


def test_beside_home_is_another_posture_within_the_limits():  # R-X19
    arm = facts()
    away = beside_home(MODEL, arm, elbow().excluded)
    assert np.all((arm.lowest <= away) & (away <= arm.highest))
    assert np.all(np.abs(away - arm.home) > 0.04)
    assert seconds_between(arm, away) == 2.0


def test_a_posture_in_which_the_robot_meets_itself_is_not_taken():  # R-X19
    wall = '<geom name="wall" type="sphere" size="1" pos="0 0 0.5"/><body name="foot">'
    model = mujoco.MjModel.from_xml_string(ARM.replace('<body name="foot">', wall))
    arm = facts()
    assert np.array_equal(beside_home(model, arm, elbow().excluded), arm.home)


def test_an_arm_of_few_joints_goes_straight_where_its_tool_keeps_its_direction():  # R-X19
    arm = facts()
    nine, _, along = straight_line(MODEL, arm, (arm,), arm.home)
    start = reach.poses(arm_constants({**arm.constants, "BASE": tuple(np.eye(4).ravel())}), [arm.home.tolist()])[0]
    assert np.allclose(nine[:6], start[:6], atol=1e-6)
    way = np.array(nine[6:9]) - start[6:9]
    assert np.allclose(along[0], arm.home) and not np.allclose(along[-1], arm.home)
    assert np.linalg.norm(way) == pytest.approx(0.06, abs=1e-5)
    turned = replace(arm, lowest=np.append(arm.lowest[:2], 0.0), highest=np.append(arm.highest[:2], 0.0))
    stuck = replace(turned, constants={**arm.constants, "QMIN": tuple(turned.lowest), "QMAX": tuple(turned.highest)})
    assert straight_line(MODEL, stuck, (stuck,), arm.home) == ((), 0.0, ())


def test_a_straight_line_on_which_the_robot_meets_itself_is_not_taken():  # R-X19
    arm = facts()
    quill = at_home(MODEL, (arm,)).body("quill")
    x, y, z = quill.xpos + quill.xmat.reshape(3, 3) @ (0.015, 0.0, -0.045)

    def barred(size):
        knob = f'<geom type="sphere" size="{size}" pos="{x} {y} {z}"/><body name="foot">'
        return mujoco.MjModel.from_xml_string(ARM.replace('<body name="foot">', knob))

    _, _, free = straight_line(MODEL, arm, (arm,), arm.home, elbow().excluded)
    _, _, around = straight_line(barred(0.01), arm, (arm,), arm.home, elbow().excluded)
    assert (free[-1][2], around[-1][2]) == pytest.approx((-0.06, 0.06), abs=1e-5)
    _, _, touching = straight_line(barred(0.04), arm, (arm,), arm.home, elbow().excluded)
    assert np.allclose(touching[-1], free[-1])  # it does so where the line begins, wherever that leads


def test_a_straight_line_takes_as_long_as_the_joints_need_for_it():  # R-X19
    model = (shipped() / "boxes" / "robot" / "puma560.xml").read_text()
    text = "VERSION 2.0\nFILE puma.xml\nARM arm\nTOOL flange\nSPEED 2 2 2 2 2 2\nEOF\n"
    sources = SourceTexts(files_of({"robot/puma.xml": model, "robot/puma.robot": text}))
    (arm,) = robot_model(sources, sources.robots["puma"], []).joints
    compiled = mujoco.MjModel.from_xml_string(model)
    away = beside_home(compiled, arm, ())
    line, quick_s, _ = straight_line(compiled, arm, (arm,), away)
    assert (len(line), quick_s) == (9, 3.0)
    slow = replace(arm, speed=arm.speed / 40.0)
    again, slow_s, _ = straight_line(compiled, slow, (slow,), away)
    assert again == line and slow_s > quick_s


def test_a_robot_that_reaches_below_its_foot_is_measured():  # R-X19
    arm = facts()
    assert lowest_point(MODEL, arm, (arm.home,)) > -1e-6
    deep = mujoco.MjModel.from_xml_string(ARM.replace('<body name="foot">', '<body name="foot" pos="0 0 -0.5">'))
    assert lowest_point(deep, arm, (arm.home,)) < -0.49
