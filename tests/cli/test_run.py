import argparse

import pytest

from onika.cli import headless_run, main, run as command


def arguments(*words):
    parser = argparse.ArgumentParser()
    command.describe(parser)
    return parser.parse_args(words)


@pytest.fixture
def started(monkeypatch, idle_starts):
    """The starts of runtimes; the command does nothing with one."""
    monkeypatch.setattr(headless_run, "run_application", lambda given, start: 0)
    return idle_starts


@pytest.mark.parametrize(
    ("words", "first"),
    [
        ([], []),
        (["--virtual"], ["--virtual"]),
        (["--scale", "2"], ["--virtual"]),
    ],
)
def test_the_runtime_comes_up_while_the_command_loads_and_ends_with_it(started, words, first):  # R-A15
    assert main(["run", "go_home", *words]) == 0
    [start] = started
    assert (start.arguments, start.options) == (first, {"has_modules": bool(first), "has_more": True})
    assert start.is_closed


@pytest.mark.parametrize("words", [["--runtime", "wss://a.example"], ["--at", "flow0=wss://a.example"]])
def test_no_runtime_comes_up_where_another_one_is_named(started, words):  # R-E12
    assert main(["run", "go_home", *words]) == 0
    assert started == []


@pytest.mark.parametrize("words", [[], ["go_home", "--from", "a.mcap"], ["go_home", "--at", "1.5"]])
def test_what_cannot_be_run_begins_nothing(started, words, capsys):  # R-E07
    with pytest.raises(SystemExit):
        main(["run", *words])
    assert (started, capsys.readouterr().err != "") == ([], True)


@pytest.mark.parametrize("text", ["", "=", "gauge=1", ".level=1", "gauge.=1", "gauge.level"])
def test_an_answer_for_nobody_is_refused(capsys, text):  # law 25
    with pytest.raises(SystemExit):
        arguments("go_home", "--answer", text)
    assert "expected TASK.NAME=VALUES" in capsys.readouterr().err


def test_a_script_that_is_not_there_is_refused(capsys):  # R-E07
    with pytest.raises(SystemExit):
        arguments("go_home", "--script", "nowhere")
    assert "expected a file of lines, found none at 'nowhere'" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["-1", "3601", "nan", "inf", "soon", ""])
def test_the_time_to_settle_is_some_seconds(capsys, text):
    with pytest.raises(SystemExit):
        arguments("go_home", f"--settle={text}")
    assert "expected seconds from 0 to 3600" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["1.5", "x", "", "1" * 19, "²", "--1", "1_000"])
def test_a_seed_is_a_whole_number(capsys, text):
    with pytest.raises(SystemExit):
        arguments("go_home", f"--seed={text}")
    assert "expected a whole number of at most 18 digits" in capsys.readouterr().err


@pytest.mark.parametrize("at", ["flow0=http://a.example", "flow0", "-1"])
def test_what_is_neither_an_instant_nor_a_runtime_is_refused(at, capsys):
    with pytest.raises(SystemExit):
        arguments("go", f"--at={at}")
    assert capsys.readouterr().err
