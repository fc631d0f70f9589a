import os
import pty
import signal

import pytest

from kit.desk.live_runtime import LiveRuntime
from onika.cli import console_session as room
from onika.cli.console_session import sit_down
from onika.cli.plain_console import PlainConsole
from onika.cli.terminal import Terminal
from onika.store.site import open_site
from onika.words.reason import Reason

SITE = open_site([], {}, None)


@pytest.fixture
def lines(monkeypatch):
    """What is piped in."""
    read, write = os.pipe()
    with os.fdopen(read) as stdin:
        monkeypatch.setattr("sys.stdin", stdin)

        def give(text):
            os.write(write, text.encode())
            os.close(write)

        yield give


def test_a_console_says_where_it_is_and_carries_out_lines(lines, capsys):  # R-A16
    lines("spawn puma\n")
    runtime = LiveRuntime(addresses=("ws://127.0.0.1:7994",))
    assert sit_down(runtime, SITE, None) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[:2] == [
        "runtime with rt0, rt1 in virtual time; `help` names the commands",
        "others reach it at ws://127.0.0.1:7994",
    ]
    assert "     0.00 s  main/puma OFF" in printed


def test_what_is_wrong_with_the_search_path_is_said_first(lines, tmp_path, capsys):  # R-X16
    (tmp_path / "onika.lock").write_text("VERSION 2.0\nLIBRARY wings\n")
    lines("quit\n")
    assert sit_down(LiveRuntime(), open_site([tmp_path], {}, None), None) == 0
    assert capsys.readouterr().out.startswith(f"{tmp_path}/onika.lock:2")


def test_a_runtime_that_cannot_be_operated_is_told(lines, capsys):
    runtime = LiveRuntime()
    runtime.refusals["Attend"] = Reason.plain("an older runtime")
    assert sit_down(runtime, SITE, None) == 1
    assert "an older runtime" in capsys.readouterr().out
    lines("")


def test_a_script_alone_or_serving_alone_needs_no_lines(monkeypatch, tmp_path, capsys):
    path = tmp_path / "start"
    path.write_text("dance\n")
    assert sit_down(LiveRuntime(), SITE, path, has_console=False) == 1
    monkeypatch.setattr(room, "serve", lambda console: 7)
    assert sit_down(LiveRuntime(), SITE, None, has_console=False) == 7


@pytest.mark.parametrize(("term", "kind"), [("xterm", Terminal), ("dumb", PlainConsole)])
def test_a_terminal_that_can_move_its_cursor_gets_a_line_to_edit(monkeypatch, tmp_path, term, kind):  # R-A16
    far, near = pty.openpty()
    monkeypatch.setenv("TERM", term)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    seen = []
    monkeypatch.setattr(room, "converse", lambda console, desk, script: seen.append(type(desk)) or 0)
    with os.fdopen(near) as stdin, os.fdopen(os.dup(near), "w") as stdout:
        monkeypatch.setattr("sys.stdin", stdin)
        monkeypatch.setattr("sys.stdout", stdout)
        assert sit_down(LiveRuntime(), SITE, None) == 0
    os.close(far)
    assert seen == [kind]


def test_a_console_that_is_told_to_end_leaves_everything_in_order(monkeypatch):
    usual = signal.getsignal(signal.SIGTERM)
    monkeypatch.setattr(room, "serve", lambda console: os.kill(os.getpid(), signal.SIGTERM))
    with pytest.raises(SystemExit) as ended:
        sit_down(LiveRuntime(), SITE, None, has_console=False)
    assert ended.value.code == 143
    assert signal.getsignal(signal.SIGTERM) is usual
