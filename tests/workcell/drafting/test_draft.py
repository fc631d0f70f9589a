import subprocess
import sys

import pytest
from msgspec import msgpack

from kit.worlds.file_cells import ARM
from kit.worlds.new_bases import CAR, SLED
from kit.worlds.robot_models import PLAIN, STATUE
from onika.files import robot as robot_file
from onika.model.robot import RobotArm, RobotBase, RobotGripper
from onika.wire.robot_draft import RobotDraft
from onika.wire.world_source import WorldFile, WorldSource
from onika.workcell.drafting.draft import draft

ON_TENDON = """<tendon><fixed name="cord"><joint joint="bend" coef="1"/></fixed></tendon>
<actuator><motor name="winch" tendon="cord"/></actuator></mujoco>"""
"""The only actuator pulls at a cord."""


def source(text):
    return WorldSource("new", "", (WorldFile("robot/new.xml", "/lab/new.xml", text.encode()),))


def devices(text):
    robot, faults = robot_file.read(draft(source(text), "new", "new.xml").text, "new", "new.robot")
    assert faults == ()
    return robot.devices


def keys(text):
    return {note.key for note in draft(source(text), "new", "new.xml").notes}


def test_an_arm_and_its_gripper_are_found_with_the_site_as_tool():  # R-X19
    arm, gripper = devices(ARM)
    assert isinstance(arm, RobotArm) and isinstance(gripper, RobotGripper)
    assert (arm.tool, arm.offset, arm.home, arm.speed, arm.torque) == (
        "tip", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (2.0, 2.0, 0.5), (40.0, 40.0, 200.0))  # fmt: skip
    assert (gripper.moves, gripper.open[0], gripper.closed[0]) == (("squeeze",), 0.03, 0.0)
    assert gripper.open[1] - gripper.closed[1] == pytest.approx(0.06, abs=1e-3)


def test_what_a_model_does_not_say_is_told():  # R-X19
    assert keys(PLAIN) >= {"workcell.draft_motors", "workcell.draft_endless", "workcell.draft_strong",
                           "workcell.draft_no_gripper"}  # fmt: skip
    assert keys(ARM) == {"workcell.draft_coupled", "workcell.draft_line_few"}


def test_every_line_that_is_no_plain_fact_says_where_it_comes_from():  # R-X19
    commented = {keyword for _, keyword, _ in draft(source(ARM), "new", "new.xml").comments}
    assert commented >= {"TOOL", "HOME", "SPEED", "TORQUE", "OPEN"}


@pytest.mark.parametrize(
    ("text", "key"),
    [
        (STATUE, "workcell.draft_no_joints"),
        (PLAIN.replace("</mujoco>", ON_TENDON), "workcell.draft_none_driven"),
        ("<mujoco><nonsense/></mujoco>", "workcell.model_unreadable"),
    ],
)
def test_a_model_of_which_no_robot_can_be_made_is_refused(text, key):  # R-X19
    answer = draft(source(text), "new", "new.xml")
    assert (answer.text, answer.refusal.key) == ("", key)


def test_of_a_model_that_only_drives_a_base_is_made_and_of_one_with_an_arm_both():  # R-X19
    (base,) = devices(CAR)
    assert isinstance(base, RobotBase) and base.wheels == ("left", "right")
    car = draft(source(CAR), "new", "new.xml")
    assert (car.home, car.ahead, car.floor) == ((), (0.3, 0.0, 0.0), 0.02)
    assert {keyword for _, keyword, _ in car.comments} >= {"WHEELS"}
    sled, arm = devices(SLED)
    assert (sled.slides, arm.start) == (("mx", "my", "mw"), "deck")
    assert len(draft(source(SLED), "new", "new.xml").home) == 2


def test_a_mesh_that_cannot_be_read_is_named():  # R-X19
    text = (
        '<mujoco><asset><mesh name="m" file="0a.stl"/></asset><worldbody><body><joint/>'
        '<geom type="mesh" mesh="m"/></body></worldbody></mujoco>'
    )
    files = (*source(text).files, WorldFile("0a.stl", "/lab/m.stl", b"no mesh at all"))
    answer = draft(WorldSource("new", "", files), "new", "new.xml")
    assert answer.refusal and answer.unusable == ("0a.stl",)


def test_it_is_a_program_that_answers_in_bytes():  # R-X19
    command = [sys.executable, "-m", "onika.workcell.drafting.draft", "new", "new.xml"]
    done = subprocess.run(command, input=msgpack.encode(source(ARM)), capture_output=True, check=True)
    assert msgpack.decode(done.stdout, type=RobotDraft) == draft(source(ARM), "new", "new.xml")
