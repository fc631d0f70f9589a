"""The cameras of a model in the draft of its description."""

import mujoco
import pytest

from kit.worlds.file_cells import ARM
from onika.files import robot as robot_file
from onika.model.camera import CameraBlock
from onika.wire.world_source import WorldFile, WorldSource
from onika.workcell.drafting.draft import draft
from onika.workcell.drafting.draft_cameras import MOST, draft_cameras


def cameras(*lines, taken=()):
    rows = "".join(f"<camera {line}/>" for line in lines)
    return draft_cameras(mujoco.MjModel.from_xml_string(f"<mujoco><worldbody>{rows}</worldbody></mujoco>"), taken)


def test_a_camera_is_called_as_in_the_model_and_as_large_as_it_says():  # R-F05, R-X19
    assert cameras('name="wrist" resolution="64 48"', 'name="top"') == (
        CameraBlock("wrist", size=(64, 48)),
        CameraBlock("top"),
    )
    assert cameras('name="huge" resolution="1920 1080"')[0].size == (320, 240)


@pytest.mark.parametrize(
    ("line", "taken", "block"),
    [
        ('name="arm"', ["arm"], CameraBlock("arm_2", "arm")),
        ('name="left/eye"', [], CameraBlock("left_eye", "left/eye")),
        ('name="2nd"', [], CameraBlock("camera_2nd", "2nd")),
    ],
)
def test_one_whose_name_is_none_of_a_device_gets_another(line, taken, block):  # R-X19
    assert cameras(line, taken=taken) == (block,)


def test_those_without_a_name_of_one_word_and_those_beyond_eight_are_left_out():  # R-X19
    assert cameras("", 'name="two words"') == ()
    assert len(cameras(*(f'name="c{k}"' for k in range(12)))) == MOST


def test_the_draft_of_a_robot_has_them_and_says_where_they_come_from():  # R-F05, R-X19
    text = ARM.replace("</worldbody>", '<camera name="eye" pos="0 0 1"/></worldbody>')
    files = WorldSource("new", "", (WorldFile("robot/new.xml", "/lab/new.xml", text.encode()),))
    drafted = draft(files, "new", "new.xml")
    robot, faults = robot_file.read(drafted.text, "new", "new.robot")
    assert (faults, [camera.name for camera in robot.cameras]) == ((), ["eye"])
    assert ("CAMERA", "CAMERA", "workcell.draft_camera") in [(a, b, why.key) for a, b, why in drafted.comments]
