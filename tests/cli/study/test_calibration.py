import pytest

from onika.cli import main

ELSEWHERE = "BEGIN\n  DRIVE calibrateC TO aside\nEND\n"


@pytest.fixture
def study(tmp_path):
    main(["study", "new", str(tmp_path / "folk")])
    return tmp_path / "folk"


@pytest.fixture
def off(tmp_path):
    """A calibration at a point where the arm does not stand."""
    (tmp_path / "off.al").write_text(ELSEWHERE)
    (tmp_path / "appl").mkdir()
    path = tmp_path / "appl" / "off.appl"
    assert main(["text", str(tmp_path / "off.al"), "-o", str(path)]) == 0
    return path


def prepare(study, *words):
    return main(["study", "prepare", str(study), "s1", "--variant", "both", *words])


@pytest.mark.site
def test_a_session_begins_with_a_calibration_and_its_result_is_told(study, capsys):  # R-H09
    assert prepare(study) == 0
    said = capsys.readouterr().out
    assert said.index("calibrate: completed") < said.index("is calibrated") < said.index("is ready")


@pytest.mark.site
def test_where_it_fails_nothing_is_readied_unless_that_is_asked_for(study, off, capsys):  # R-H09
    assert prepare(study, "--calibration", str(off)) == 1
    said = capsys.readouterr().out
    assert "found it -0.800 rad away" in said
    assert "nothing is readied" in said
    assert not (study / "sessions").exists()
    assert prepare(study, "--calibration", str(off), "--uncalibrated") == 0
    assert "failed" in capsys.readouterr().out
    assert (study / "sessions" / "s1").is_dir()


def test_a_calibration_that_is_not_there_is_a_failure(study, capsys):  # R-H09
    assert prepare(study, "--calibration", "none_such") == 1
    assert "none_such" in capsys.readouterr().out
    assert not (study / "sessions").exists()


@pytest.mark.site
def test_it_is_done_in_the_workcell_in_which_the_page_will_run(study, capsys):  # R-H09
    address = "ws://127.0.0.1:1"
    assert prepare(study, "--runtime", address) == 1
    capsys.readouterr()
    assert prepare(study, "--runtime", address, "--uncalibrated") == 0
    assert f"--connect {address}" in capsys.readouterr().out


def test_a_subject_who_cannot_have_a_session_moves_no_robot(study, capsys):  # R-H09
    assert main(["study", "prepare", str(study), "s1"]) == 2
    assert capsys.readouterr().out.count("Calibration") == 0
