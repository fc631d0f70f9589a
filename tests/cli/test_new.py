import pytest

from kit.worlds.file_cells import ARM
from kit.worlds.new_bases import CAR, SLED
from kit.worlds.robot_models import FAULTS, FAULTY, PLAIN, STATUE
from onika.cli import main


def test_the_files_that_were_made_are_listed_with_what_to_do_next(tmp_path, capsys):  # R-K05
    assert main(["new", "module", "gain", "--in", str(tmp_path)]) == 0
    *paths, advice = capsys.readouterr().out.splitlines()
    assert paths == [str(tmp_path / "module" / "gain.py"), str(tmp_path / "module" / "gain.rmod"),
                     str(tmp_path / "tests" / "test_gain.py")]  # fmt: skip
    assert advice == f"try it: onika check {tmp_path}; python -m pytest {paths[-1]}"


def test_where_pytest_is_missing_it_is_said_how_it_comes(tmp_path, capsys, monkeypatch):  # R-K05
    monkeypatch.setattr("onika.cli.new.find_spec", lambda _name: None)
    assert main(["new", "module", "gain", "--in", str(tmp_path)]) == 0
    assert "python -m pip install pytest; python -m pytest" in capsys.readouterr().out


def test_a_second_time_nothing_is_written_and_it_is_said_why(tmp_path, capsys):  # R-B08
    assert main(["new", "module", "gain", "--in", str(tmp_path)]) == 0
    capsys.readouterr()
    assert main(["new", "module", "gain", "--in", str(tmp_path)]) == 1
    captured = capsys.readouterr()
    assert "is there already: nothing was written" in captured.err
    assert captured.out == ""


@pytest.mark.parametrize("name", ["9lives", "../up", ""])
def test_what_is_no_name_is_refused_with_what_was_expected(tmp_path, capsys, name):
    assert main(["new", "module", name, "--in", str(tmp_path)]) == 1
    assert "expected a name" in capsys.readouterr().err


def test_a_place_that_cannot_be_written_to_is_told(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert main(["new", "module", "gain", "--in", str(tmp_path / "file")]) == 1
    assert capsys.readouterr().err


def test_only_what_there_is_a_template_for_can_be_made(capsys):
    with pytest.raises(SystemExit):
        main(["new", "planet", "gain"])
    assert "module" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "text"),
    [("elbow.xml", ARM), ("plain.xml", PLAIN), ("six.urdf", FAULTY), ("sled.xml", SLED), ("car.xml", CAR)],
)
def test_of_a_model_a_robot_is_made_that_is_checked_and_runs_at_once(tmp_path, capsys, file, text):  # R-X19
    (tmp_path / file).write_text(text)
    mine, name = tmp_path / "mine", file.partition(".")[0]
    assert main(["new", "robot", str(tmp_path / file), "--in", str(mine)]) == 0
    out = capsys.readouterr().out
    assert f"{mine}/robot/{name}.robot" in out
    assert all(f"note: {fault}" in out for fault in (FAULTS if text == FAULTY else ()))
    assert main(["check", str(mine)]) == 0
    assert main(["run", f"{name}_tour", "--local", str(mine), "--virtual"]) == 0
    assert main(["test", str(mine)]) == 0


def test_a_model_of_which_no_robot_can_be_made_is_refused_with_the_reason(tmp_path, capsys):  # R-X19
    (tmp_path / "stone.xml").write_text(STATUE)
    assert main(["new", "robot", str(tmp_path / "stone.xml"), "--in", str(tmp_path / "mine")]) == 1
    assert "nothing to move" in capsys.readouterr().err
    assert not (tmp_path / "mine").exists()
