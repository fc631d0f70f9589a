from pathlib import Path

import pytest

from onika.cli import check as room, main
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

FAULT = Fault(Place("a.rmod", 3), Reason.plain("expected one, found two"), Reason.plain("left out"))
OTHER = Fault(Place("b.rmod"), Reason.plain("expected one, found two"), Reason.plain("left out"))


@pytest.fixture
def survey_results(monkeypatch):
    """What a survey of each path finds, in order."""
    results = []
    monkeypatch.setattr(room, "survey", lambda path, site, note: results.pop(0))
    return results


def test_every_fault_is_printed_once_and_counted(survey_results, capsys):  # R-B07
    survey_results += [([Path("a"), Path("b")], [FAULT, OTHER]), ([Path("c")], [FAULT])]
    assert main(["check", "x", "y"]) == 1
    assert capsys.readouterr().out.splitlines() == [
        "a.rmod:3: expected one, found two; instead: left out",
        "b.rmod: expected one, found two; instead: left out",
        "3 files read, 2 faults",
    ]


@pytest.mark.parametrize(
    ("files", "faults", "line", "code"),
    [(1, 0, "1 file read, no faults", 0), (2, 1, "2 files read, 1 fault", 1), (0, 0, "0 files read, no faults", 0)],
)
def test_numbers_are_told_as_people_say_them(survey_results, capsys, files, faults, line, code):
    survey_results.append(([Path(str(number)) for number in range(files)], [FAULT] * faults))
    assert main(["check", "x"]) == code
    assert capsys.readouterr().out.splitlines()[-1] == line


def test_without_a_path_it_says_what_it_wants(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["check"])
    assert ended.value.code == 2
    assert "PATH" in capsys.readouterr().err
