import argparse

import pytest

from onika.cli import headless_run, main, run as command
from onika.desk.run.outcome import Outcome
from onika.desk.trial import keeping
from onika.wire import event
from onika.words.reason import NOTHING, Reason

pytestmark = pytest.mark.usefixtures("idle_starts")

RESULT = event.Result(True, NOTHING, 1, 1, 2.0, 0.1, {}, (), "")


@pytest.fixture
def runs(monkeypatch):
    """The settings of each run that would have been, and how it ends."""
    seen = []

    def run(settings, site, watcher, opens, start):
        seen.append((settings, site, watcher))
        return Outcome(settings.name, result=RESULT, snapshots={"boxes": b"drawn"} if settings.wants_picture else {})

    monkeypatch.setattr(headless_run, "run", run)
    return seen


def settings_of(runs, *words):
    assert main(["run", *words]) == 0
    return runs[-1][0]


def test_a_run_is_as_usual_unless_said_otherwise(runs):  # R-E01
    settings = settings_of(runs, "go_home")
    assert (settings.name, settings.is_virtual, settings.expectations, settings.settle_s) == ("go_home", False, (), 0.5)
    assert (settings.seed, settings.answers, settings.wants_picture, settings.with_fifo) == (0, (), False, True)


def test_every_option_reaches_the_run(runs, tmp_path):
    words = ("--virtual", "--expect", "A == 1", "--expect", "B > 2", "--settle", "1.5", "--seed", "-7", "--no-fifo")
    settings = settings_of(runs, "x.appl", *words, "--local", str(tmp_path))
    assert settings.is_virtual
    assert [expectation.text for expectation in settings.expectations] == ["A == 1", "B > 2"]
    assert (settings.settle_s, settings.seed, settings.with_fifo) == (1.5, -7, False)
    assert runs[-1][1].directories[0].path == tmp_path


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (["gauge.level=0.5"], (("gauge", "level", "0.5"),)),
        (["gauge.level=1,2 3"], (("gauge", "level", "1 2 3"),)),
        (["a.x=1", "b.y=2", "a.z=3"], (("a", "x", "1"), ("b", "y", "2"), ("a", "z", "3"))),
        (["my.task.level=1"], (("my.task", "level", "1"),)),
        (["a.x="], (("a", "x", ""),)),
        (["a.x=b=c"], (("a", "x", "b=c"),)),
    ],
)
def test_answers_are_taken_by_task_and_name(runs, given, expected):  # law 25
    words = [word for answer in given for word in ("--answer", answer)]
    assert settings_of(runs, "go_home", *words).answers == expected


@pytest.mark.parametrize(
    ("words", "tty", "term", "kind"),
    [
        (["--json"], True, "xterm", "JsonLines"),
        ([], True, "xterm", "LiveDisplay"),
        ([], True, "dumb", "PlainDisplay"),
        ([], False, "xterm", "PlainDisplay"),
    ],
)
def test_it_is_told_as_whoever_reads_it_can_read(runs, monkeypatch, words, tty, term, kind):  # R-E11
    monkeypatch.setattr("sys.stdout.isatty", lambda: tty, raising=False)
    monkeypatch.setenv("TERM", term)
    settings_of(runs, "go_home", *words)
    assert type(runs[-1][2]).__name__ == kind


@pytest.mark.parametrize(("words", "tty", "may_ask"), [([], True, True), (["--json"], True, False), ([], False, False)])
def test_it_asks_only_where_somebody_can_answer(runs, monkeypatch, words, tty, may_ask):  # law 25
    monkeypatch.setattr("sys.stdin.isatty", lambda: tty, raising=False)
    assert settings_of(runs, "go_home", *words).may_ask is may_ask


@pytest.mark.parametrize(
    ("words", "has_script", "on_error"),
    [
        ([], False, "abort"),
        ([], True, "wait"),
        (["--on-error", "abort"], True, "abort"),
        (["--on-error", "wait"], False, "wait"),
    ],
)
def test_at_an_error_it_waits_where_somebody_could_go_on(runs, tmp_path, words, has_script, on_error):  # R-E08
    path = tmp_path / "s"
    path.write_text("pause\n")
    settings = settings_of(runs, "go_home", *words, *(["--script", str(path)] if has_script else []))
    assert (settings.on_error, settings.script) == (on_error, path if has_script else None)


@pytest.mark.parametrize("on_loss", ["stop", "finish", "run"])
def test_what_becomes_of_it_when_this_program_is_gone_is_chosen(runs, on_loss):  # R-E10
    assert settings_of(runs, "go_home", "--on-loss", on_loss).on_loss == on_loss


def test_a_picture_is_drawn_of_the_first_world(runs, monkeypatch, capsys, tmp_path):
    drawn = headless_run.world_picture
    monkeypatch.setattr(drawn, "draw", lambda snapshot, path: Reason.plain(f"{snapshot!r} to {path.name}"))
    settings_of(runs, "go_home", "--picture", str(tmp_path / "out.png"))
    assert capsys.readouterr().out.splitlines()[-1] == "b'drawn' to out.png"
    monkeypatch.setattr(drawn, "draw", lambda snapshot, path: NOTHING)
    settings_of(runs, "go_home", "--picture", "out.png")
    assert capsys.readouterr().out.splitlines()[-1] == "picture: out.png"


def test_an_early_end_says_so_by_its_exit_code(monkeypatch, capsys):  # R-E07
    for raised, code in ((KeyboardInterrupt, 130), (BrokenPipeError, 1), (TimeoutError("no answer"), 1)):

        def run(*_, raised=raised):
            raise raised

        monkeypatch.setattr(headless_run, "run", run)
        assert main(["run", "go_home"]) == code
    assert "no answer" in capsys.readouterr().err


def test_a_good_run_is_kept_as_a_test(runs, monkeypatch, tmp_path, capsys):  # R-X07
    kept = []

    def keep_in(path, settings, site, **more):
        kept.append((path, settings.name, more["seen"]))
        return len(kept) == 1, (Reason.plain("25 actions"),)

    monkeypatch.setattr(keeping, "keep_in", keep_in)
    words = ["run", "go_home", "--virtual", "--keep-test", str(tmp_path / "a.test")]
    assert main(words) == 0
    assert kept == [(tmp_path / "a.test", "go_home", "")]
    assert main(words) == 1
    assert capsys.readouterr().err.splitlines() == [f"test: {tmp_path / 'a.test'}: 25 actions", "no test: 25 actions"]


@pytest.mark.parametrize(
    ("words", "remedy"),
    [(["--keep-test", "a.test"], "give --virtual"), (["--virtual", "--keep-test", "a.txt"], ".test")],
)
def test_a_run_that_cannot_be_kept_is_refused_before_it_begins(runs, capsys, words, remedy):  # R-X07
    with pytest.raises(SystemExit) as end:
        main(["run", "go_home", *words])
    assert (end.value.code, runs) == (2, [])
    assert remedy in capsys.readouterr().err


def test_a_run_that_failed_is_not_kept(runs, monkeypatch, tmp_path):  # R-X07
    monkeypatch.setattr(keeping, "keep_in", lambda *_args, **_more: pytest.fail("it was kept"))
    monkeypatch.setattr(headless_run, "run", lambda settings, *_: Outcome("go_home", faults=[]))
    assert main(["run", "go_home", "--virtual", "--keep-test", str(tmp_path / "a.test")]) == 2


def test_flows_are_given_to_runtimes_each_with_its_token(tmp_path):  # R-E12, R-F02
    for name in ("any", "own"):
        (tmp_path / name).write_text(f"{name:x<43}\n")
        (tmp_path / name).chmod(0o600)
    parser = argparse.ArgumentParser()
    command.describe(parser)
    words = ["go", "--at", "flow0=wss://a.example", "--at", "flow1=wss://b.example", "--at", "flow2=wss://b.example"]
    given = parser.parse_args(
        [*words, "--token-file", str(tmp_path / "any"), "--token-file", f"flow1={tmp_path / 'own'}"]
    )
    places = headless_run._settings(given, can_steer=False).places
    assert [(flow, location.url) for flow, location in places] == [
        ("flow0", "wss://a.example:7994"), ("flow1", "wss://b.example:7994"), ("flow2", "wss://b.example:7994")
    ]  # fmt: skip
    assert [location.token.strip("x") for _, location in places] == ["any", "own", "own"]
