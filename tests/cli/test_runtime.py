from typing import ClassVar

import pytest

from onika.cli import console_session, main, runtime as room
from onika.link.lost import LinkLost, LossCause
from onika.words.reason import Reason


class Launched:
    """A runtime that is not launched; it remembers how it would have been."""

    seen: ClassVar[list] = []

    def __init__(self, *given):
        self.seen.append(given)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass


@pytest.fixture
def sits(monkeypatch):
    """How the console would have been held."""
    seen = []
    Launched.seen = []
    monkeypatch.setattr(room, "LaunchedRuntime", Launched)
    monkeypatch.setattr(
        console_session, "sit_down", lambda runtime, site, script, **given: seen.append((site, script, given)) or 0
    )
    return seen


def test_a_runtime_is_started_for_this_console_alone_unless_said_otherwise(sits):  # R-A16
    assert main(["runtime"]) == 0
    assert Launched.seen == [(("rt0",), False, True, (), True)]
    ((_, script, given),) = sits
    assert (script, given) == (None, {"has_console": True})


def test_every_option_reaches_the_runtime_or_the_console(sits, tmp_path):  # R-A06, R-A16
    path = tmp_path / "start"
    path.write_text("")
    words = [
        "--virtual",
        "--rtpu",
        "a",
        "--rtpu",
        "b",
        "--no-fifo",
        "--no-black-box",
        "--script",
        str(path),
        "--no-console",
    ]
    assert main(["runtime", *words, "--base", str(tmp_path)]) == 0
    assert Launched.seen == [(("a", "b"), True, False, (), False)]
    ((site, script, given),) = sits
    assert (site.directories[0].path, script, given["has_console"]) == (tmp_path, path, False)


def test_the_network_channel_is_opened_at_the_start(sits):  # R-A16
    words = ["--listen", "127.0.0.1:0", "--users", "u", "--name", "arm", "--library", "https://x/arm", "--accept-code"]
    assert main(["runtime", *words]) == 0
    assert Launched.seen[0][3] == tuple(words)


def test_how_long_a_holder_may_be_silent_and_where_all_is_written_down_is_said_to_the_runtime(sits):  # R-X12
    assert main(["runtime", "--audit", "trail", "--lease", "0.5"]) == 0
    assert Launched.seen[0][3] == ("--audit", "trail", "--lease", "0.5")


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [(["--listen", "0.0.0.0:1"], 2, "--users: expected a file"), ([], 1, "the runtime is gone: it ended")],
)
def test_a_runtime_that_does_not_start_says_why(sits, monkeypatch, capsys, words, code, sentence):
    class Stillborn(Launched):
        def __enter__(self):
            raise LinkLost(LossCause.CLOSED, Reason.plain("the runtime is gone: it ended"))

        def printed(self):
            return "--users: expected a file\n"

    monkeypatch.setattr(room, "LaunchedRuntime", Stillborn)
    assert main(["runtime", *words]) == code
    assert capsys.readouterr().err.strip() == sentence
    assert sits == []


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--no-console"], "expected --listen or --script with --no-console"),
        (["--cert", "c"], "expected --listen HOST:PORT with --cert"),
        (["--script", "none"], "expected a file of lines, found none at 'none'"),
        (["--rtpu", "7"], "expected a name of letters, digits"),
        (["--base", "none"], "expected a base directory"),
        (["--lease", "5"], "expected 0.2 to 3 seconds, found '5'"),
        (["--lease", "soon"], "expected 0.2 to 3 seconds, found 'soon'"),
    ],
)
def test_a_wrong_command_line_is_told_and_ends_with_2(sits, capsys, words, sentence):
    with pytest.raises(SystemExit) as ended:
        main(["runtime", *words])
    assert ended.value.code == 2
    assert sentence in capsys.readouterr().err
    assert Launched.seen == []
