import pytest

from onika.workcell.arms import Arms
from onika.workcell.boxes import BoxesWorld
from onika.workcell.kinematic_unit import KinematicUnit


def unit_of(arms, name):
    return next(unit for unit in arms.units if unit.sheet.name == name)


def acting(arms):
    return [arm.sheet.name for arm in arms]


def test_where_nothing_is_claimed_the_pumas_stand_with_all_their_forces():
    arms = Arms()
    assert acting(arms) == ["arm_left", "arm_right"]
    assert not arms.kinematic
    assert arms.moving(("left", "right")) == ()


def test_an_arm_that_is_let_in_changes_its_own_place_and_the_mode_of_all():  # law 18
    arms = Arms()
    assert arms.admit(unit_of(arms, "scara_left_kin"))
    assert acting(arms) == ["scara_left_kin", "arm_right_kin"]
    assert arms.kinematic
    assert arms.kinds() == {"left": "scara", "right": "arm"}
    assert [type(unit) for unit in arms.moving(("right",))] == [KinematicUnit]


def test_an_arm_that_is_there_already_changes_nothing():
    arms = Arms()
    assert not arms.admit(unit_of(arms, "arm_left"))


@pytest.mark.parametrize(
    ("used", "wanted", "sentence"),
    [("arm_left", "scara_left", "expected a free place"), ("arm_right", "arm_left_kin", "expected arms of one mode")],
)
def test_an_arm_in_use_stands_against_others_at_its_place_and_against_the_other_mode(used, wanted, sentence):  # law 18
    arms = Arms()
    unit_of(arms, used).epoch = 1
    with pytest.raises(ValueError, match=sentence):
        arms.admit(unit_of(arms, wanted))
    assert acting(arms) == ["arm_left", "arm_right"]


def test_all_arms_of_a_place_hang_on_one_drive():
    arms = Arms()
    drives = {unit.side: unit.drive for unit in arms.units}
    assert all(unit.drive is drives[unit.side] for unit in arms.units)
    assert drives["left"] is not drives["right"]


def test_a_hand_that_no_arm_of_a_flow_bears_is_remarked():  # R-X02
    world = BoxesWorld()
    (remark,) = world.remarks(("arm_right", "gripper_left", "lamp"))
    assert str(remark) == "gripper_left is the hand at the left, and the arm that moves is arm_right"
    assert len(world.remarks(("scara_left", "gripper_right"))) == 1
    for sound in (("arm_right", "gripper_right"), ("scara_left_kin", "gripper_left"), ("gripper_left",), ("arm_left",)):
        assert world.remarks(sound) == ()
    assert world.remarks(("arm_left", "gripper_left", "gripper_right")) == ()
