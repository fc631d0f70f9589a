from onika.model import job_pictures
from onika.model.picture import SIZE, framed


def robot(column):
    """A picture of a post in a column."""
    return framed(["7" * column + "3" + "7" * (SIZE - column - 1)] * SIZE).rows


def test_a_move_of_joints_shows_where_the_arm_was_in_grey_and_where_it_comes_to():  # R-X19, R-B11
    rows = job_pictures.of_joints(robot(20), robot(24)).rows
    assert rows[15][20] == "6" and rows[15][24] == "3"
    assert {cell for row in rows for cell in row} == set("03678")


def test_an_arrow_stands_where_least_is():  # R-X19, R-B11
    for column, half in ((5, slice(16, None)), (27, slice(0, 16))):
        rows = job_pictures.of_line(robot(column)).rows
        red = [row[half].count("0") for row in rows]
        assert sum(red) == sum(row.count("0") for row in rows) > 20


DRAWN = ("of_hand", "of_opened", "of_closed", "of_base", "of_goal", "of_goal_behind")


def test_what_a_hand_and_a_base_do_is_drawn_each_in_its_own_way():  # R-X19, R-B11
    pictures = [getattr(job_pictures, name)() for name in DRAWN]
    assert len({picture.rows for picture in pictures}) == len(DRAWN)
    assert all({"0", "7", "8"} <= {cell for row in picture.rows for cell in row} for picture in pictures)
