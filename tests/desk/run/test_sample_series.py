import csv
import io
import struct

from hypothesis import given, strategies as st

from onika.desk.run.sample_series import SampleSeries, columns, csv as written
from onika.wire.samples import SampleStretch, SampleTrace
from onika.words.shape import Shape

MS = 1_000_000


def trace(name, type_, first, begin_ns, *rows):
    values = b"".join(struct.pack(f"{len(row)}d", *row) for row in rows)
    return SampleTrace(name, type_, (SampleStretch(first, begin_ns, 2 * MS, len(rows)),), values)


def test_values_that_never_came_are_counted_between_those_that_did():  # R-C14
    series = SampleSeries("main/X")
    assert series.take(trace("main/X", "double", 5, 0, (1.0,), (2.0,)))
    assert series.take(trace("main/X", "double", 10, 10 * MS, (3.0,)))
    assert not series.take(SampleTrace("main/X", "double"))
    assert (series.missed, series.last, series.times) == (3, 10, [0, 2 * MS, 10 * MS])
    assert series.rows == [[1.0], [2.0], [3.0]]


def test_what_came_before_and_after_a_stretch_is_cut_off():
    series = SampleSeries("main/X")
    series.take(trace("main/X", "double", 5, 0, (1.0,), (2.0,), (3.0,), (4.0,)))
    series.cut(2 * MS, 4 * MS)
    assert (series.times, series.rows) == ([2 * MS, 4 * MS], [[2.0], [3.0]])


def test_a_column_stands_for_each_element():
    assert columns("Q", Shape.parse("double")) == ["Q"]
    assert columns("Q", Shape.parse("double[2]")) == ["Q[0]", "Q[1]"]
    assert columns("Q", Shape.parse("double[1,2]")) == ["Q[0,0]", "Q[0,1]"]
    assert columns("Q", None) == []


def test_variables_of_several_rates_share_a_table_and_leave_empty_what_was_not_written():  # R-C14
    fast, slow = SampleSeries("main/F"), SampleSeries("main/M")
    fast.take(trace("main/F", "double", 1, 4 * MS, (1.0,), (2.0,), (3.0,)))
    slow.take(trace("main/M", "double[1,2]", 1, 6 * MS, (0.1, -4.0)))
    rows = list(csv.reader(io.StringIO(written([fast, slow], 4 * MS))))
    assert rows == [
        ["t_s", "main/F", "main/M[0,0]", "main/M[0,1]"],
        ["0.000000", "1.0", "", ""],
        ["0.002000", "2.0", "0.1", "-4.0"],
        ["0.004000", "3.0", "", ""],
    ]


@given(st.lists(st.floats(allow_nan=False), min_size=1, max_size=20))
def test_numbers_are_read_back_exactly(values):  # R-C14
    series = SampleSeries("main/F")
    series.take(trace("main/F", "double", 1, 0, *((value,) for value in values)))
    rows = list(csv.reader(io.StringIO(written([series]))))[1:]
    assert [float(row[1]) for row in rows] == values
