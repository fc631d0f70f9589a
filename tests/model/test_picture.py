import pytest

from onika.model.picture import BLACK, COLOURS, SIZE, SIZES, Picture, blank, framed


@pytest.mark.parametrize("size", SIZES)
def test_a_framed_picture_has_a_black_border_and_keeps_its_inside(size: int) -> None:
    picture = framed(["0" * size] * size)  # R-B11, R-B09
    assert (picture.size, picture.is_larger) == (size, size > SIZE)
    assert picture.rows[0] == picture.rows[-1] == BLACK * size
    assert all(row == BLACK + "0" * (size - 2) + BLACK for row in picture.rows[1:-1])
    assert blank(size) == framed(["7" * size] * size)


def test_the_blank_picture_is_white_within_black() -> None:
    assert set("".join(blank().rows)) == {str(COLOURS.index("white")), str(COLOURS.index("black"))}


@pytest.mark.parametrize(
    "rows",
    [
        *[("8" * SIZE,) * (SIZE - 1), ("8" * (SIZE - 1),) * SIZE, ("9" * SIZE,) * SIZE, ("8" * SIZE + "\n",) * SIZE],
        *[("8" * 40,) * 40, ("8" * 48,) * SIZE, ("8" * SIZE,) * 48],
    ],
)
def test_anything_but_as_many_digits_as_rows_is_no_picture(rows: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match="expected 32, 48 or 64 rows of as many digits"):
        Picture(rows)


def test_a_picture_with_a_coloured_border_is_refused() -> None:
    with pytest.raises(ValueError, match="black border"):
        Picture(("0" * SIZE,) * SIZE)


def test_rows_of_other_lengths_cannot_be_framed() -> None:
    with pytest.raises(ValueError, match="expected 32, 48 or 64 rows"):
        framed(["8" * SIZE])
