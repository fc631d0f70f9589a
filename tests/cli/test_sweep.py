import pytest

from onika.cli import main, sweep as room
from onika.desk.sweep.case import CaseResult
from onika.words.reason import Reason


@pytest.fixture
def sweeps(monkeypatch, tmp_path):
    """What each sweep was asked for; runs of a seed in `bad` fall, and it is broken off at the seed `ends_at`."""
    monkeypatch.chdir(tmp_path)

    def sweep(design, prepared, cases, site, jobs):
        for case in cases:
            if case.seed == sweep.ends_at:
                raise KeyboardInterrupt
            sweep.seeds.append(case.seed)
            sweep.settings = design.settings_of(case)
            fell = Reason.plain("it fell") if case.seed in sweep.bad else Reason.plain("")
            yield CaseResult(case, "aborted" if fell else "completed", fell, lasted_s=2.0 + case.seed)

    sweep.seeds, sweep.bad, sweep.ends_at, sweep.settings = [], (), None, None
    monkeypatch.setattr(room, "sweep", sweep)
    return sweep


def test_a_sweep_says_how_many_are_good_and_keeps_all_results(sweeps, capsys, tmp_path):  # R-X23
    assert main(["sweep", "go_home", "--seeds", "4"]) == 0
    out = capsys.readouterr().out
    assert "go_home: 4 runs, 4 good: 100.0 %" in out
    assert len((tmp_path / "go_home.sweep").read_text().splitlines()) == 5
    assert (sweeps.settings.shake, sweeps.settings.is_virtual) == (3, True)


def test_what_failed_first_is_told_with_the_command_that_does_it_again(sweeps, capsys):  # R-X23
    sweeps.bad = (5,)
    assert main(["sweep", "go_home", "--seeds", "4..7", "--vary", "pd.STIFF=0.5..1"]) == 1
    out = capsys.readouterr().out
    assert "    1  it fell (such as seed 5)" in out
    value = dict(sweeps.settings.values)["pd.STIFF"]  # of the last seed
    assert "onika run go_home --virtual --seed 5 --shake 5 --vary pd.STIFF=0." in out
    assert f"{value!r}" not in out
    assert out.count(" % of ") == 4


def test_a_sweep_that_was_broken_off_goes_on_where_it_was(sweeps, capsys):  # R-X23
    sweeps.ends_at = 2
    assert main(["sweep", "go_home", "--seeds", "4"]) == 130
    assert "broken off: 2 of 4 runs are not done" in capsys.readouterr().out
    sweeps.ends_at = None
    assert main(["sweep", "go_home", "--seeds", "4"]) == 0
    assert sweeps.seeds == [0, 1, 2, 3]
    assert main(["sweep", "go_home", "--seeds", "6"]) == 0
    assert sweeps.seeds == [0, 1, 2, 3, 4, 5]


def test_another_sweep_does_not_touch_the_results_of_the_first(sweeps, capsys):  # R-X23
    main(["sweep", "go_home", "--seeds", "2"])
    assert main(["sweep", "go_home", "--seeds", "2", "--no-shake"]) == 2
    assert "expected the results of `go_home --no-shake`, found those of `go_home`" in capsys.readouterr().err
    assert main(["sweep", "go_home", "--seeds", "2", "--no-shake", "--out", "still.sweep"]) == 0


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("nothing_here",), "nothing_here"),
        (("go_home", "--vary", "pd.STIFFNESS=1..2"), "expected one of the LOCAL lines"),
        (("go_home", "--vary", "pf.STIFF=1..2"), "found no task pf"),
    ],
)
def test_what_cannot_be_swept_is_told_before_anything_runs(sweeps, capsys, words, told):  # R-X23
    assert main(["sweep", *words]) == 2
    assert told in capsys.readouterr().err
    assert sweeps.seeds == []


@pytest.mark.parametrize("words", [("--seeds", "0"), ("--seeds", "5..2"), ("--vary", "pd.STIFF"), ("--jobs", "many")])
def test_odd_words_are_refused_with_what_was_expected(sweeps, capsys, words):  # R-X23
    with pytest.raises(SystemExit) as ended:
        main(["sweep", "go_home", *words])
    assert ended.value.code == 2
    assert "expected" in capsys.readouterr().err


def test_results_are_drawn_and_written_as_json(sweeps, capsys, tmp_path):  # R-X23
    assert main(["sweep", "go_home", "--seeds", "3", "--plot", "a.svg", "--json"]) == 0
    captured = capsys.readouterr()
    assert len(captured.out.splitlines()) == 3
    assert "plot: a.svg" in captured.err
    assert (tmp_path / "a.svg").read_text().startswith("<svg")
    assert main(["sweep", "go_home", "--seeds", "3", "--plot", "no/a.svg"]) == 0
    assert "no/a.svg" in capsys.readouterr().err
