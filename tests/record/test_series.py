from kit.record.recording_builder import RecordingBuilder
from onika.record.series import Series


def test_a_variable_keeps_its_value_until_the_next_one(tmp_path):  # R-X05
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.variable("M", "double[2,2]", (0.5, [[1, 2], [3, 4]]), (1.0, [[5, 6], [7, 8]]), unit="rad")
    series = Series.all_of(tape.end())["flow0/M"]
    assert [series.at(at) for at in (499_999_999, 500_000_000)] == [None, [[1.0, 2.0], [3.0, 4.0]]]
    assert series.at(10**12) == [[5.0, 6.0], [7.0, 8.0]]
    assert list(series.values(600_000_000)) == [(1_000_000_000, [[5.0, 6.0], [7.0, 8.0]])]
    assert next(series.flat()) == (500_000_000, [1.0, 2.0, 3.0, 4.0])
    assert series.labels == ["M[0,0]", "M[0,1]", "M[1,0]", "M[1,1]"]
    assert (series.unit, series.name, series.subsystem) == ("rad", "M", "flow0")


def test_a_scalar_has_one_label_and_only_variables_are_series(tmp_path):
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.variable("LAMP", "int", (0.0, 1))
    tape.show(0.0, "/worlds/boxes/frames", "foxglove.FrameTransforms", b"{}", b'{"transforms":[]}')
    series = Series.all_of(tape.end())
    assert list(series) == ["flow0/LAMP"]
    assert series["flow0/LAMP"].labels == ["LAMP"]
    assert list(series["flow0/LAMP"].flat()) == [(0, [1])]
