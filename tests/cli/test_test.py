from pathlib import Path

import pytest

from onika.cli import main, test as room
from onika.desk.trial.judging import Verdict
from onika.desk.trial.trial import Trial
from onika.words.reason import Reason

GOOD = Trial("tests/a.test", Verdict((), (Reason.plain("a lift is left out"),), 23.3), 1.5)
BAD = Trial("tests/b.test", Verdict((Reason.plain("flow0: LAMP at the end: expected 1, found 0"),), (), 23.3), 2.0)


@pytest.fixture
def done(monkeypatch):
    """What comes out of all tests, and how they were asked for."""
    results, requests = [], []

    def try_all(files, site, **more):
        requests.append((files, more))
        return iter(results)

    monkeypatch.setattr(room, "find", lambda paths, word: ([Path(f"{paths[0]}/{word}.test")], []))
    monkeypatch.setattr(room, "try_all", try_all)
    return results, requests


def test_good_tests_are_counted_and_end_with_0(done, capsys):  # R-X07
    done[0].append(GOOD)
    assert main(["test"]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "passed  tests/a.test  23.30 s, in 1.5 s of wall time",
        "    note: a lift is left out",
        "1 of 1 passed",
    ]
    assert done[1][0][0] == [Path("tests/.test")]


def test_a_failure_is_told_in_words_and_ends_with_1(done, capsys):  # R-X07
    done[0].extend([GOOD, BAD])
    assert main(["test"]) == 1
    assert capsys.readouterr().out.splitlines()[-3:] == [
        "FAILED  tests/b.test  23.30 s, in 2.0 s of wall time",
        "    flow0: LAMP at the end: expected 1, found 0",
        "1 of 2 passed, 1 failed",
    ]


def test_words_shakes_jobs_and_the_report_are_handed_on(done, tmp_path):  # R-X07
    done[0].append(BAD)
    report = tmp_path / "out.xml"
    assert main(["test", "here", "-k", "lamp", "--shake", "3", "--jobs", "7", "--junit", str(report)]) == 1
    assert done[1] == [([Path("here/lamp.test")], {"workers": 7, "shakes": 3})]
    assert b'failures="1"' in report.read_bytes()


def test_no_tests_are_an_error_and_not_a_success(tmp_path, capsys):  # R-X07
    assert main(["test", str(tmp_path)]) == 2
    assert "expected a test file" in capsys.readouterr().err
    (tmp_path / "a.test").write_text("EOF\n")
    assert main(["test", str(tmp_path), "-k", "zebra"]) == 2
    assert "no test has 'zebra' in its name" in capsys.readouterr().err


def test_a_wrong_number_is_refused(capsys):  # R-B07
    with pytest.raises(SystemExit) as end:
        main(["test", "--shake", "-1"])
    assert end.value.code == 2
