import math

import pytest
from hypothesis import given, strategies as st

from onika.desk.run.explanation_text import lines
from onika.wire import event
from onika.words.reason import Reason

AT = tuple(number * 0.05 for number in range(61))
EXPLAINED = event.Explained(
    subsystem="flow0", task="puma", action="jmoveC home", index=4, place="together.appl:117",
    text=Reason.plain("cycle: NaN in TAU_REF"), path="/home/u/puma.py", line=88,
    waiting=(("flow1", "lift"), ("flow2", "")),
    courses=(event.Course("Q_MEZ", "rad", AT, tuple([0.0, number * 0.1] for number in range(61))),),
    choices=(("clear flow0", Reason.plain("clears puma")), ("abort", Reason.plain("ends the run"))),
    at_s=12.345, kind="error", suspect="poison",
)  # fmt: skip


def lines_of(width=100, **changes):
    fields = {name: getattr(EXPLAINED, name) for name in EXPLAINED.__struct_fields__}
    return list(lines(event.Explained(**(fields | changes)), width))


def course(*values, unit="rad", variable="X"):
    at = tuple(number * 0.05 for number in range(len(values)))
    return {"courses": (event.Course(variable, unit, at, values),)}


def row(*values, **given):
    (line,) = [line.strip() for line in lines_of(**course(*values, **given)) if " X" in line]
    return line.partition("X")[2].split(maxsplit=1)


def test_a_stop_is_told_in_a_few_lines():  # R-X06, R-E11
    assert lines_of() == [
        "   12.35 s  STOP flow0/puma: cycle: NaN in TAU_REF",
        " suspect     poison",
        " chain       puma > action 5, jmoveC home > flow0 > flow1 waits at lift > flow2 waits",
        " where       /home/u/puma.py:88, together.appl:117",
        " last 3.0 s  Q_MEZ[1] ▁▁▁▁▁▂▂▂▂▂▃▃▃▃▃▄▄▄▄▄▅▅▅▅▅▆▆▆▆▇▇▇▇▇▇█████ 0 to 6 rad",
        " you can     clear flow0  clears puma",
        "             abort        ends the run",
    ]


def test_the_end_of_a_run_is_told_as_such():  # R-X06
    shown = lines_of(
        choices=(), courses=(), task="", subsystem="", suspect="", waiting=(), action="", path="", place=""
    )
    assert shown == ["   12.35 s  END: cycle: NaN in TAU_REF"]


def test_a_value_that_is_no_number_is_marked():  # R-X06
    assert row(1.0, 3.0, 2.0, math.nan) == ["▁█▅×", "1 to nan (1..3) rad"]
    assert row(math.inf) == ["×", "inf rad"]


def test_of_a_vector_the_element_without_a_number_is_shown_else_the_one_that_moved_most():  # R-X06
    assert row([0.0, 5.0], [9.0, math.nan])[0].startswith("[1]")
    assert row([0.0, 5.0], [9.0, 5.0])[0].startswith("[0]")
    assert row([[0.0], [5.0]], [[1.0], [9.0]])[0].startswith("[1,0]")


def test_a_value_that_stands_is_one_number():  # R-X06
    assert row(2.0, 2.0, unit="-") == ["──", "2"]
    assert row(1.5708, 1.57081, 1.5708) == ["───", "1.571 rad"]
    assert row(0.0, 0.0) == ["──", "0 rad"]


def test_an_element_has_its_own_unit():  # R-X06
    assert row([0.0, 1.0], [0.0, 3.0], unit="m,m/s")[1].endswith("1 to 3 m/s")
    assert row(0.0, 1.0, unit="m,m/s")[1].endswith("0 to 1 m,m/s")


def test_short_spans_are_told_more_exactly():  # R-X06
    assert any(line.startswith(" last 0.10 s") for line in lines_of(**course(1.0, 2.0, 3.0)))


@pytest.mark.parametrize("width", [60, 80, 120])
def test_a_block_fits_its_width_and_loses_no_word(width):  # R-X06
    text = (
        "the servo of joint two hears nothing of the trajectory for longer than it may wait for it to come back again"
    )
    block = lines_of(width, text=text)
    assert max(map(len, block)) <= width
    assert text in " ".join(" ".join(line.split()) for line in block)


@pytest.mark.parametrize("values", [(1.23456e-9, -9.87654e-8, 5.43219e-7, -1.23456e-8), (1.0, 2.0)])
def test_a_row_fits_80_columns_however_long_its_numbers(values):  # R-X06
    block = lines_of(80, **course(*values, unit="N m s/rad", variable="Q^_REFERENCE"))
    assert max(map(len, block)) <= 80


def test_a_long_path_is_never_broken():  # R-X06
    path = "/home/user/" + "robots/" * 12 + "puma.py"
    assert any(f"{path}:88" in line for line in lines_of(60, path=path))


@given(
    st.lists(st.lists(st.floats(), min_size=2, max_size=2), min_size=1, max_size=80),
    st.integers(20, 200),
    st.text(max_size=200),
)
def test_anything_can_be_told(samples, width, text):  # R-X06
    block = lines_of(width, text=text, **course(*samples))
    assert block
    assert all("\n" not in line for line in block)
