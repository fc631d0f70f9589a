import pytest

from kit.record.recording_builder import RecordingBuilder, run
from onika.cli import main


@pytest.fixture
def files(tmp_path):
    for name, last in (("a", 2.0), ("b", 2.5)):
        tape = RecordingBuilder(tmp_path / f"{name}.mcap")
        tape.variable("X", "double", (0.0, 1.0), (1.0, last))
        tape.variable("Y", "int", (0.0, 7))
        tape.end(completed="yes")
    return str(tmp_path / "a.mcap"), str(tmp_path / "b.mcap")


def test_a_recording_is_shown(files, capsys):  # R-X05
    assert main(["recording", "show", files[0]]) == 0
    assert "completed" in capsys.readouterr().out


def test_variables_are_written_as_a_table(files, tmp_path, capsys):  # R-X05
    assert main(["recording", "csv", files[0], "X"]) == 0
    assert capsys.readouterr().out.split() == ["time_s,flow0/X", "0.000000000,1.0", "1.000000000,2.0"]
    assert main(["recording", "csv", files[0], "--output", str(tmp_path / "x.csv")]) == 0
    assert (tmp_path / "x.csv").read_text().splitlines()[0] == "time_s,flow0/X,flow0/Y"
    assert capsys.readouterr().out.startswith("2 rows of 2 variables")
    assert main(["recording", "csv", files[0], "Z"]) == 2


def test_the_first_difference_is_told_and_the_exit_code_says_whether_there_is_one(files, capsys):  # R-X05
    assert main(["recording", "diff", *files]) == 1
    assert capsys.readouterr().out == "at 1 s: flow0/X: 2.0, in the other 2.5\n"
    assert main(["recording", "diff", *files, "--tolerance", "0.5"]) == 0
    assert capsys.readouterr().out == "no difference\n"


def test_what_is_no_recording_is_said(tmp_path, capsys):  # R-E01
    assert main(["recording", "show", str(tmp_path / "none.mcap")]) == 2
    assert "none.mcap" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["recording", "diff", "a", "b", "--time", "-1"])


def test_a_recording_is_not_written_over_by_its_own_table(files, tmp_path, capsys):  # R-E01
    before = (tmp_path / "a.mcap").read_bytes()
    assert main(["recording", "csv", files[0], "--output", files[0]]) == 2
    assert "another file" in capsys.readouterr().err
    assert (tmp_path / "a.mcap").read_bytes() == before


def test_a_file_that_is_spoilt_or_cut_is_told_by_its_name(files, tmp_path, capsys):  # R-E01, R-X05
    data = (tmp_path / "b.mcap").read_bytes()
    (tmp_path / "b.mcap").write_bytes(data[:-9])
    assert main(["recording", "diff", files[0], files[1], "--tolerance", "1"]) == 0
    assert f"{files[1]} was cut short: compared up to 1 s" in capsys.readouterr().out
    for more in ([], ["--output", str(tmp_path / "b.csv")]):
        assert main(["recording", "csv", files[1], *more]) == 0
        assert f"{files[1]} was cut short: the table ends at 1 s" in capsys.readouterr().err
    assert main(["recording", "csv", files[0]]) == 0
    assert capsys.readouterr().err == ""
    place = data.index(b"plan.json") + 60
    (tmp_path / "b.mcap").write_bytes(data[:place] + b"#" + data[place + 1 :])
    for words in (["show", files[1]], ["csv", files[1]], ["diff", *files]):
        assert main(["recording", *words]) == 2
        assert files[1] in capsys.readouterr().err


@pytest.fixture
def boxes(tmp_path):
    """A whole run of 4 s, and black boxes from 2 s on: of its end, and of a fault after which it went on."""
    courses = {"whole": (None, 0.0), "end": ((2.0, 4.0), 2.0), "fault": ((2.0, 3.0), 2.0)}
    for name, (held_s, begin) in courses.items():
        tape = RecordingBuilder(tmp_path / f"{name}.mcap", held_s=held_s)
        tape.variable("X", "double", *((at, at) for at in (0.0, 2.0, 3.0, 4.0) if begin <= at <= (held_s or (0, 4))[1]))
        tape.end(completed="no", **{"goes_on": "yes"} if name == "fault" else {})
    return {name: str(tmp_path / f"{name}.mcap") for name in courses}


def test_show_says_of_a_black_box_from_when_to_when_it_is(boxes, capsys):  # R-X05
    assert main(["recording", "show", boxes["end"]]) == 0
    assert "a black box: the last seconds of a run that ended badly, from 2 s to 4 s\n" in capsys.readouterr().out
    assert main(["recording", "show", boxes["fault"]]) == 0
    stood = "a black box: the last seconds before the run stood still, from 2 s to 3 s; it was not over then\n"
    assert stood in capsys.readouterr().out
    assert main(["recording", "show", boxes["whole"]]) == 0
    assert "black box" not in capsys.readouterr().out


def test_diff_says_over_what_time_a_black_box_was_compared(boxes, capsys):  # R-X05
    for pair in (("whole", "end"), ("end", "whole")):
        assert main(["recording", "diff", *(boxes[name] for name in pair)]) == 0
        said = "no difference\na black box: compared from 2 s to 4 s, times within 0.03 s\n"
        assert capsys.readouterr().out == said
    assert main(["recording", "diff", boxes["whole"], boxes["fault"], "--time", "0.1"]) == 0
    assert "a black box: compared from 2 s to 3 s, times within 0.1 s\n" in capsys.readouterr().out
    assert main(["recording", "diff", boxes["whole"], boxes["whole"]]) == 0
    assert capsys.readouterr().out == "no difference\n"


def test_runs_in_wall_time_are_compared_as_such_unless_it_is_said(tmp_path, capsys):  # R-X05
    files = []
    for name, speed in (("a", 1.0), ("b", 9.0)):
        tape = RecordingBuilder(tmp_path / f"{name}.mcap", run(is_virtual=False))
        tape.variable("Q^", "double", (0.0, 0.0), (1.0, speed), unit="rad/s")
        tape.end(completed="yes")
        files.append(str(tape.path))
    assert main(["recording", "diff", *files]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[0] == "no difference"
    assert "speeds and forces are not compared" in printed[1]
    assert main(["recording", "diff", *files, "--tolerance", "1"]) == 1
