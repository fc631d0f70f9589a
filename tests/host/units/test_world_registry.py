import pytest
from hypothesis import given, strategies as st

from onika.host.units.world_registry import open_world, refuse_unknown, split


def test_a_world_is_found_by_its_name():  # law 16
    world = open_world("boxes")
    assert {"arm_left", "gripper_left", "lamp"} <= {sheet.name for sheet in world.devices()}
    assert open_world("boxes") is not world


def test_a_shaken_world_has_its_things_a_little_elsewhere_the_same_for_one_seed():  # R-X07
    poses = [open_world("boxes", shake).poses() for shake in (None, 1, 1, 2)]
    assert (poses[1] == poses[2]).all()
    for pose in (poses[1], poses[3]):
        assert 1e-5 < abs(pose - poses[0]).max() <= 0.0010001
    assert abs(poses[3] - poses[1]).max() > 1e-5


def test_a_world_that_cannot_be_shaken_is_as_it_is(monkeypatch):  # R-X07
    monkeypatch.delattr("onika.workcell.boxes.BoxesWorld.shaken")
    assert (open_world("boxes", 1).poses() == open_world("boxes").poses()).all()


def test_an_unknown_world_names_those_there_are():  # law 16
    with pytest.raises(ValueError, match=r"expected a world \(boxes.*\), found 'atlantis'"):
        open_world("atlantis")


def test_a_world_that_is_not_open_is_refused_with_those_that_are():
    refuse_unknown("sea", ("yard", "sea"))
    with pytest.raises(ValueError, match=r"expected an open world \(sea, yard\), found 'lake'"):
        refuse_unknown("lake", ("yard", "sea"))
    with pytest.raises(ValueError, match="none is open"):
        refuse_unknown("lake", ())


def test_a_device_is_a_world_and_a_name():  # law 16
    assert split("boxes:arm_left") == ("boxes", "arm_left")
    assert split("a:b:c") == ("a", "b:c")


@given(st.text(max_size=10))
def test_whatever_is_no_device_is_refused_with_what_was_expected(text):
    world, colon, name = text.partition(":")
    if world and colon and name:
        assert split(text) == (world, name)
    else:
        with pytest.raises(ValueError, match="expected WORLD:DEVICE"):
            split(text)
