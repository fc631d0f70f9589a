"""A robot as its file says."""

from onika.model.robot import RobotText


def test_the_models_of_a_robot_are_its_own_and_that_of_its_hand():  # R-X19
    assert RobotText("r", "arm.xml").models == ("arm.xml",)
    assert RobotText("r", "arm.xml", hand="hand.xml", on="flange").models == ("arm.xml", "hand.xml")
