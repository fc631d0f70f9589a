import shlex
import signal
import sys

import pytest

from onika.cli import main

PREPARED = ("study", "prepare", "--no-calibration")
WORDS = ("s1", "--variant", "words")


def test_how_the_page_is_started_is_told_and_leads_nowhere_out_of_the_home(tmp_path, capsys):  # R-H09
    study = tmp_path / "folk for us"
    assert main(["study", "new", str(study)]) == 0
    capsys.readouterr()
    assert main(["study", "prepare", str(study), "s1", "--variant", "both", "--no-calibration"]) == 0
    said = capsys.readouterr().out
    command = shlex.split(next(line for line in said.splitlines() if line.startswith("  env ")))
    assert f"HOME={study / 'sessions' / 's1'}" in command
    assert "XDG_STATE_HOME" in command
    assert command[command.index("--presentation") + 1] == "both"
    assert command[command.index("--window") + 1] == "1280x900+0+0"
    assert shlex.quote(str(study)) in said.splitlines()[-1]


def test_a_session_is_held_to_the_dictionaries_that_its_task_is_about(tmp_path, capsys):  # R-H09, R-H06
    main(["study", "new", str(tmp_path / "folk")])
    assert main([*PREPARED, str(tmp_path / "folk"), *WORDS, "--dictionary", "boxes", "--dictionary", "puma"]) == 0
    assert " --dictionary boxes --dictionary puma" in capsys.readouterr().out
    assert main([*PREPARED, str(tmp_path / "folk"), "s2", "--variant", "both", "--dictionary", "fruit"]) == 2
    refused = capsys.readouterr().err
    assert "expected one of boxes, " in refused and "found fruit" in refused
    assert not (tmp_path / "folk" / "sessions" / "s2").exists()


@pytest.mark.parametrize("variant", ["pictures", "words"])
def test_who_shall_see_all_icons_at_once_is_told_so_but_not_of_words_which_have_no_room(tmp_path, capsys, variant):
    main(["study", "new", str(tmp_path / "folk")])  # R-H05, R-H09
    assert main([*PREPARED, str(tmp_path / "folk"), "s1", "--variant", variant]) == 0
    said = capsys.readouterr().out
    assert ("can be seen" in said, "scrolled" in said) == (variant == "pictures", variant == "words")


def test_a_session_is_begun_and_ended_in_one_go(tmp_path, capfd, monkeypatch):  # R-H09
    study = tmp_path / "folk"
    main(["study", "new", str(study)])
    page = tmp_path / "page.py"
    page.write_text(
        "import os, pathlib, sys; place = pathlib.Path(os.environ['HOME'], '.local/state/onika/diary')"
        "; place.mkdir(parents=True); (place / 'a.log').write_text(' '.join(sys.argv[1:]))"
    )
    monkeypatch.setattr(sys, "argv", [str(page)])
    assert main([*PREPARED, str(study), *WORDS, "--open", "--window", "900x700"]) == 0
    log = (study / "logs" / "s1" / "a.log").read_text()
    assert log.startswith("page --upper --presentation words --window 900x700+0+0 --base ")
    assert log.endswith(" --ends-with-window")
    assert "is ended" in capfd.readouterr().out


def test_a_session_whose_page_never_came_up_is_taken_back(tmp_path, capfd, monkeypatch):  # R-H09
    study = tmp_path / "folk"
    main(["study", "new", str(study)])
    page = tmp_path / "page.py"
    page.write_text("raise SystemExit(2)")
    monkeypatch.setattr(sys, "argv", [str(page)])
    for _ in range(2):
        assert main([*PREPARED, str(study), *WORDS, "--open"]) == 2
        assert "can be prepared anew" in capfd.readouterr().err
        assert not (study / "sessions" / "s1").exists()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_preparation_that_is_told_to_end_ends_its_page_and_its_session(tmp_path, monkeypatch, number):  # R-H09
    study = tmp_path / "folk"
    main(["study", "new", str(study)])
    page = tmp_path / "page.py"
    page.write_text(
        "import os, pathlib, signal; place = pathlib.Path(os.environ['HOME'], '.local/state/onika/diary')"
        "; place.mkdir(parents=True); signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGTERM])"
        f"; os.kill(os.getppid(), {int(number)}); (place / 'a.log').write_text(signal.sigwait([signal.SIGTERM]).name)"
    )
    monkeypatch.setattr(sys, "argv", [str(page)])
    before = signal.getsignal(number)
    assert main([*PREPARED, str(study), *WORDS, "--open"]) == 0
    assert (study / "logs" / "s1" / "a.log").read_text() == "SIGTERM"
    assert signal.getsignal(number) is before


def test_what_cannot_be_prepared_is_refused(tmp_path, capsys):  # R-H09
    assert main(["study", "prepare", str(tmp_path / "none"), "s1", "--variant", "both"]) == 2
    assert main(["study", "prepare", str(tmp_path), "s1"]) == 2
    assert capsys.readouterr().out == ""
    assert [*tmp_path.iterdir()] == []
