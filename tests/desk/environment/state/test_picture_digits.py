import pytest

from onika.desk.environment.state.picture_digits import painted
from onika.model.picture import Picture


def test_a_picture_gets_its_black_border_and_a_nine_is_black():  # R-B11, reading 38
    picture = painted("7" * 500 + "9" + "7" * 523)
    assert isinstance(picture, Picture)
    assert picture.rows[0] == "8" * 32 and picture.rows[15][20] == "8" and picture.rows[1] == "8" + "7" * 30 + "8"


@pytest.mark.parametrize("size", [32, 48, 64])
def test_the_digits_of_a_picture_say_how_large_it_is(size):  # R-B09
    picture = painted("7" * size * size)
    assert isinstance(picture, Picture)
    assert picture.size == size and picture.rows[1] == "8" + "7" * (size - 2) + "8"


@pytest.mark.parametrize("digits", ["", "7" * 1023, "7" * 1023 + "x", "7" * 1023 + "٣", "7" * 40 * 40])
def test_what_is_no_picture_is_told(digits):  # R-D07
    picture = painted(digits)
    assert str(picture).startswith("expected 1024, 2304 or 4096 digits")
