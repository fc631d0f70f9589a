import pytest

from onika.desk.plan.shifted_jump import shifted
from onika.wire.plan import Again, Choose, Do, Jump, Meet, Unless


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (Jump(3), Jump(5)),
        (Again("loop", 0), Again("loop", 2)),
        (Unless("loop", 4), Unless("loop", 6)),
        (Choose((1, 7)), Choose((3, 9))),
    ],
)
def test_what_is_jumped_to_lies_later(before, after):  # R-E06
    assert shifted(before, 2) == after


@pytest.mark.parametrize("instruction", [Do(1), Meet("tag")])
def test_what_jumps_nowhere_stays_as_it_is(instruction):
    assert shifted(instruction, 2) == instruction
