import pytest

from onika.desk.console import status
from onika.desk.run import text_table
from onika.model.preferences import STATUS_COLUMNS
from onika.wire.live import TaskFigure

FIGURE = TaskFigure(
    "main",
    "pd",
    "pd",
    "rt0",
    17,
    "P",
    2,
    "cycle",
    250,
    3,
    500.0,
    498.0,
    2.0,
    25.5,
    1e-6,
    0.01,
    0.2,
    0.05,
    0.02,
    0.4,
    0.1,
    1,
)


@pytest.mark.parametrize(
    ("column", "text"),
    [
        ("tid", "17"),
        ("S", "P"),
        ("crit", "2"),
        ("state", "cycle"),
        ("cycle", "250"),
        ("miss", "3"),
        ("ref-F", "500.0"),
        ("ref-T", "2.000"),
        ("mez-F", "498.0"),
        ("mez-T", "2.008"),
        ("ptime", "2.00"),
        ("tot-C", "25.50"),
        ("tick", "0.000001"),
        ("min-U", "1.0"),
        ("max-U", "20.0"),
        ("avg-U", "5.0"),
        ("min-C", "0.020"),
        ("max-C", "0.400"),
        ("avg-C", "0.100"),
        ("warn", "1"),
        ("rmod", "pd"),
        ("rtpu", "rt0"),
    ],
)
def test_a_column_says_its_figure(column, text):  # R-A11
    assert status.cell(FIGURE, column) == text


def overview(figures, columns):
    """The table in English."""
    return text_table.lines(*status.overview(figures, columns))


def test_every_column_of_statinfo_can_be_shown():  # R-A11
    assert [line.split()[0] for line in status.whole(FIGURE)[1:]] == list(STATUS_COLUMNS)
    assert len(status.overview([FIGURE], STATUS_COLUMNS)[0]) == 1 + len(STATUS_COLUMNS)


def test_a_task_without_a_rate_has_no_period():
    from msgspec.structs import replace

    figure = replace(FIGURE, ref_hz=0.0, mez_hz=0.0)
    assert [status.cell(figure, name) for name in ("ref-F", "ref-T", "mez-F", "mez-T")] == ["-"] * 4


def test_subsystems_are_named_where_there_are_several():
    from msgspec.structs import replace

    assert overview([FIGURE], ("warn",)) == ["task  warn", "pd       1"]
    both = overview([FIGURE, replace(FIGURE, subsystem="left")], ("warn",))
    assert both == ["subsystem  task  warn", "main       pd       1", "left       pd       1"]
