"""The middle of a colour."""

import numpy as np
import pytest

from onika.laws.pictures.blob import ColourBlob


def picture(*spots):
    pixels = np.full((48, 64, 3), 150, np.uint8)
    for rows, columns, rgb in spots:
        pixels[rows, columns] = rgb
    return pixels


def test_the_middle_of_a_colour_is_found_to_a_part_of_a_pixel():  # R-K04
    pixels = picture((slice(10, 14), slice(20, 30), (200, 30, 20)), (slice(30, 40), slice(0, 9), (20, 30, 200)))
    assert ColourBlob((1, 0, 0), 40.0).middle(pixels) == (24.5, 11.5, 40)
    assert ColourBlob((0, 0, 1), 40.0).middle(pixels) == (4.0, 34.5, 90)


def test_a_shape_in_bright_light_has_the_colour_that_it_has_in_shadow():  # R-K04
    for rgb in ((255, 120, 110), (90, 10, 8)):
        assert ColourBlob((1, 0, 0), 40.0).middle(picture((slice(5, 7), slice(5, 7), rgb))) == (5.5, 5.5, 4)


def test_what_has_another_colour_or_none_is_not_seen():
    assert ColourBlob((0, 1, 0), 40.0).middle(picture((slice(5, 9), slice(5, 9), (200, 190, 20)))) == (0.0, 0.0, 0)
    assert ColourBlob((1, 0, 0), 40.0).middle(picture((slice(5, 9), slice(5, 9), (170, 150, 150)))) == (0.0, 0.0, 0)


@pytest.mark.parametrize("rgb", [(1, 1, 1), (0, 0, 0), (float("nan"), 0, 1)])
def test_grey_is_no_colour(rgb):
    with pytest.raises(ValueError, match="expected a colour"):
        ColourBlob(rgb, 40.0)
