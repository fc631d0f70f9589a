import pytest

from onika.model.picture import BLACK, COLOURS, SIZE, Picture, blank, framed


def test_a_framed_picture_has_a_black_border_and_keeps_its_inside() -> None:
    picture = framed(["0" * SIZE] * SIZE)  # R-B11
    assert picture.rows[0] == picture.rows[-1] == BLACK * SIZE
    assert all(row == BLACK + "0" * (SIZE - 2) + BLACK for row in picture.rows[1:-1])


def test_the_blank_picture_is_white_within_black() -> None:
    assert set("".join(blank().rows)) == {str(COLOURS.index("white")), str(COLOURS.index("black"))}


@pytest.mark.parametrize(
    "rows",
    [("8" * SIZE,) * (SIZE - 1), ("8" * (SIZE - 1),) * SIZE, ("9" * SIZE,) * SIZE, ("8" * SIZE + "\n",) * SIZE],
)
def test_anything_but_32_rows_of_32_digits_is_no_picture(rows: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match="expected 32 rows of 32 digits"):
        Picture(rows)


def test_a_picture_with_a_coloured_border_is_refused() -> None:
    with pytest.raises(ValueError, match="black border"):
        Picture(("0" * SIZE,) * SIZE)


def test_rows_of_other_lengths_cannot_be_framed() -> None:
    with pytest.raises(ValueError, match="expected 32 rows"):
        framed(["8" * SIZE])
