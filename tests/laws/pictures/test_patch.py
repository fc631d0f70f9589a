"""A point that is found again."""

import numpy as np
import pytest

from onika.laws.pictures.patch import PicturePatch


def scene(right, down, light=1.0):
    """A blue box with its corner at (100 + right, 60 + down), on a brown ground."""
    pixels = np.full((120, 160, 3), (160, 130, 90), np.float64)
    pixels[60 + down : 100 + down, 60 + right : 100 + right] = (30, 60, 190)
    return np.clip(pixels * light, 0, 255).astype(np.uint8)


def test_a_point_is_followed_from_picture_to_picture():  # R-F05
    patch = PicturePatch(scene(0, 0), 100.0, 60.0)
    for step in range(1, 9):
        assert patch.find(scene(-5 * step, 4 * step))
        assert patch.at == (100.0 - 5 * step, 60.0 + 4 * step)


def test_another_light_does_not_lead_it_astray():  # R-F05
    patch = PicturePatch(scene(0, 0), 98.0, 63.0)
    assert patch.find(scene(7, -6, light=0.7))
    assert patch.at == (105.0, 57.0)


def test_what_is_gone_is_not_found():
    patch = PicturePatch(scene(0, 0), 100.0, 60.0)
    assert not patch.find(np.full((120, 160, 3), (160, 130, 90), np.uint8))
    assert patch.at == (100.0, 60.0)


def test_a_point_at_the_edge_is_followed_by_what_lies_within():
    pixels = scene(-60, -60)  # the box begins in the corner of the picture
    assert PicturePatch(pixels, 38.0, 1.0).at == (38.0, 1.0)


@pytest.mark.parametrize(("u", "v"), [(20.0, 20.0), (-1.0, 5.0), (160.0, 5.0), (5.0, 120.0)])
def test_where_nothing_can_be_found_again_no_point_is_taken(u, v):
    with pytest.raises(ValueError, match="expected"):
        PicturePatch(scene(0, 0), u, v)


def test_a_picture_smaller_than_what_is_compared_has_no_points():
    with pytest.raises(ValueError, match="expected a point"):
        PicturePatch(np.zeros((16, 16, 3), np.uint8), 8.0, 8.0)
