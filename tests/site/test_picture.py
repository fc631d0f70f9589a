"""A picture of the workcell at the end of a run, and what is said where none can be drawn."""

import struct

import pytest

from kit.labs.laboratory import Laboratory, job
from onika.cli import main

pytestmark = pytest.mark.site


def test_a_picture_of_the_workcell_is_drawn_at_the_end(capsys, tmp_path):
    path = tmp_path / "end.png"
    assert main(["run", "go_home", "--virtual", "--picture", str(path)]) == 0
    line = capsys.readouterr().out.splitlines()[-1]
    if "Install" in line:
        pytest.skip(line)
    assert line == f"picture: {path}"
    data = path.read_bytes()
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", data[16:24])
    assert width >= 960 <= height


@pytest.mark.parametrize(("expectation", "code"), [("Q_MEZ[0] < 1", 0), ("Q_MEZ[0] > 1", 1)])
def test_without_graphics_it_is_said_what_to_install_and_the_run_counts(
    capsys, tmp_path, monkeypatch, expectation, code
):
    monkeypatch.setenv("MUJOCO_GL", "disable")
    path = tmp_path / "none.png"
    words = ["run", "go_home", "--virtual", "--expect", expectation, "--picture", str(path)]
    assert main(words) == code
    line = capsys.readouterr().out.splitlines()[-1]
    assert "Install libegl1" in line
    assert not path.exists()


def test_where_no_picture_can_be_written_nothing_is_run(capsys, tmp_path):
    for place in (tmp_path / "nowhere" / "end.png", tmp_path):
        with pytest.raises(SystemExit) as ended:
            main(["run", "go_home", "--virtual", "--picture", str(place)])
        assert ended.value.code == 2
    assert "expected a file in a directory that is there" in capsys.readouterr().err
    assert not (tmp_path / "nowhere").exists()


def test_a_run_without_a_world_has_nothing_to_draw(capsys, tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.module(
        "halt",
        "from onika.module import Module, finish\n"
        "class Halt(Module):\n"
        "    trigger = True\n"
        "    def cycle(self):\n"
        "        return finish()\n",
    )
    laboratory.plain_task("halt")
    laboratory.configuration("haltC", "halt 50")
    path = laboratory.application("halt", [job("haltC")])
    assert main(["run", str(path), "--virtual", "--picture", str(tmp_path / "end.png")]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "no picture: there is no world to draw"


def test_a_graphics_library_that_is_not_there_is_a_fault_of_what_needs_it_and_no_traceback(
    capsys, monkeypatch
):  # R-B07
    monkeypatch.setenv("MUJOCO_GL", "nonsense")  # the library of the worlds refuses to be imported
    assert main(["run", "go_home", "--virtual"]) == 2
    captured = capsys.readouterr()
    assert "go_home: refused, nothing moved" in captured.out
    assert "invalid value for environment variable MUJOCO_GL: nonsense" in captured.out
    assert captured.err == ""
