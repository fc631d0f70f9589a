from pathlib import Path

import pytest

from onika.cli import main

TEXT = "BEGIN\n  DRIVE jmoveC TO home\nEND\n"


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HOME", str(tmp_path))
    return tmp_path


def test_an_application_is_printed_as_text_and_saved_back(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["text", "go_home"]) == 0  # R-D14
    printed = capsys.readouterr().out
    assert "\n  DRIVE jmoveC TO home (" in printed
    assert main(["text", "go_home", "-o", "a.al"]) == 0
    assert capsys.readouterr().out == "a.al\n"
    assert (here / "a.al").read_text() == printed
    assert main(["text", "a.al", "-o", "a.appl"]) == 0
    assert main(["text", "a.appl"]) == 0
    assert capsys.readouterr().out == "a.appl\n" + printed.replace("{ go_home }", "{ a }")


def test_a_whole_text_defines_its_icons(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["text", "go_home", "--whole"]) == 0
    assert "\nICON        jmoveC\n" in capsys.readouterr().out


def test_a_file_is_replaced_only_when_that_is_said(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "a.al").write_text(TEXT)
    assert main(["text", "a.al", "-o", "a.appl"]) == 0
    assert main(["text", "a.al", "-o", "a.appl"]) == 1
    assert "a.appl is there already" in capsys.readouterr().err
    assert main(["text", "a.al", "-o", "a.appl", "--overwrite"]) == 0


def test_every_fault_is_told_on_the_error_output_and_nothing_is_written(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (here / "a.al").write_text("BEGIN\n  go\n  DRIVE jmoveC TO hom\nEND\n")
    assert main(["text", "a.al", "-o", "a.appl"]) == 1
    captured = capsys.readouterr()
    assert [line.partition(": ")[0] for line in captured.err.splitlines()] == ["a.al:2", "a.al:3"]
    assert captured.out == ""
    assert not (here / "a.appl").exists()


def test_the_wrong_ending_and_a_missing_file_are_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["text", "go_home", "-o", "a.appl"]) == 1
    assert main(["text", "nowhere"]) == 1
    first, second = capsys.readouterr().err.splitlines()
    assert first.startswith("a.appl: expected a file name that ends with .al")
    assert second.startswith("nowhere: expected a file that can be read")
