from xml.etree.ElementTree import Element

import numpy as np

from onika.store.urdf_inertia import possible_inertia


def inertia(xx, yy, zz, xy=0.0):
    return Element("inertia", ixx=str(xx), iyy=str(yy), izz=str(zz), ixy=str(xy), ixz="0", iyz="0")


def moments(element):
    keys = (("ixx", "ixy", "ixz"), ("ixy", "iyy", "iyz"), ("ixz", "iyz", "izz"))
    return np.linalg.eigvalsh([[float(element.get(key)) for key in row] for row in keys])


def test_a_sound_inertia_stays_as_it_is():  # R-X19
    element = inertia(0.02, 0.03, 0.04, 0.001)
    assert not possible_inertia(element)
    assert (element.get("ixx"), element.get("ixy")) == ("0.02", "0.001")


def test_an_impossible_inertia_becomes_one_that_a_body_can_have():  # R-X19
    for element in (
        inertia(0.01, 0.01, 0.5),
        inertia(-0.01, 0.02, 0.02),
        inertia(0, 0, 0),
        inertia(1e-4, 1e-4, 1e-4, 1),
    ):
        assert possible_inertia(element)
        least, middle, most = moments(element)
        assert least > 0.0 and least + middle >= most * (1.0 - 1e-9)
