import csv
import io

from kit.record.recording_builder import RecordingBuilder
from onika.record import columns
from onika.record.series import Series


def test_a_table_has_a_row_for_each_time_at_which_something_changed(tmp_path):  # R-X05
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.variable("X", "double[2]", (0.0, [1, 2]), (0.5, [3, 4]))
    tape.variable("LAMP", "int", (0.25, 7), (0.5, 8))
    stream = io.StringIO()
    assert columns.write(stream, list(Series.all_of(tape.end()).values())) == 3
    assert list(csv.reader(io.StringIO(stream.getvalue()))) == [
        ["time_s", "flow0/LAMP", "flow0/X[0]", "flow0/X[1]"],
        ["0.000000000", "", "1.0", "2.0"],
        ["0.250000000", "7", "1.0", "2.0"],
        ["0.500000000", "8", "3.0", "4.0"],
    ]


def test_nothing_makes_a_table_of_its_head_alone():
    stream = io.StringIO()
    assert columns.write(stream, []) == 0
    assert stream.getvalue().strip() == "time_s"
