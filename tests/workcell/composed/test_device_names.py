"""What devices are called."""

from onika.model.robot import RobotArm, RobotGripper, RobotText
from onika.workcell.composed.device_names import device_name

ARM, OTHER, HAND = RobotArm("arm", "tip"), RobotArm("second", "tip"), RobotGripper("hand", ("m",), (1, 1), (0, 0))


def test_an_arm_is_called_by_its_robot_and_a_hand_by_its_word():  # R-X19
    robot = RobotText("panda", "p.xml", devices=(ARM, HAND))
    assert device_name(ARM, robot, [robot], "left") == "panda_left"
    assert device_name(HAND, robot, [robot], "left") == "hand_left"
    assert device_name(ARM, robot, [robot], "-") == "panda"


def test_robots_with_devices_of_one_word_have_their_names_before_it():
    robot, other = RobotText("a", "p.xml", devices=(ARM, OTHER, HAND)), RobotText("b", "p.xml", devices=(HAND,))
    assert device_name(HAND, robot, [robot, other], "left") == "a_hand_left"
    assert device_name(OTHER, robot, [robot, other], "left") == "a_second_left"
