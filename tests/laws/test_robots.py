import pytest

from onika.laws import adept_one, puma560
from onika.laws.robots import robot_of


def test_a_robot_is_known_by_its_name():
    assert (robot_of("puma560"), robot_of("adept_one")) == (puma560, adept_one)


def test_an_unknown_robot_is_refused_with_those_that_are_known():
    with pytest.raises(ValueError, match="expected one of puma560, adept_one, found kuka"):
        robot_of("kuka")
