import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.robot import published, unlike


@pytest.mark.parametrize("robot", [puma560, adept_one])
def test_everything_that_is_known_is_published_in_shapes_that_agree(robot):  # law 20
    constants = published(robot, 0.0, 0.0, 0.0, 0.0)
    n = constants["NDOF"]
    shapes = {"SCREW": (n, 6), "LINK": (n, 13), "PARENT": (n,), "LOAD": (4,), "BASE": (4, 4), "TOOL": (4, 4)}
    for name in ("QMIN", "QMAX", "Q^_MAX", "TAUMAX", "KP", "KD", "HOME"):
        shapes[name] = (n,)
    assert {name: np.shape(constants[name]) for name in shapes} == shapes
    assert set(constants) == {*shapes, "NDOF", "ROBOT"}


def test_a_base_is_turned_about_z_and_moved():
    base = published(puma560, 1.25, 0.1, 0.2, 90.0)["BASE"]
    assert base @ [1.0, 0.0, 0.0, 1.0] == pytest.approx([1.25, 1.1, 0.2, 1.0])


def test_another_robot_and_one_that_stands_elsewhere_are_told_from_it():
    here = published(puma560, 0.0, 0.0, 0.0, 0.0)
    assert unlike("puma560", here, here) is None
    assert unlike("adept", here, here) == "expected the robot adept behind the device, found puma560"
    turned = unlike("puma560", here, published(puma560, 0.0, 0.5, 0.0, 90.0))
    assert turned and turned.endswith("found it at 0 0.5 0 m, turned by 90 degrees")
