import os
import re
import subprocess
import sys

import pytest

from onika.cli import commands, page
from onika.web.server import bound


@pytest.fixture
def began(monkeypatch):
    """With what the program would begin, without beginning it."""
    seen = []

    class EnvironmentProgram:
        def __init__(self, site, options, state):
            seen.append((site, options, state))

        async def run(self, opens):
            seen.append(opens)

    monkeypatch.setattr("onika.web.program.EnvironmentProgram", EnvironmentProgram)
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    return seen


@pytest.mark.parametrize("words", [[], ["--port", "0"], ["page"], ["page", "jmoveC", "--no-browser"]])
def test_onika_alone_opens_the_page(began, capsys, words):  # R-C20
    assert commands.carry_out(words) == 0
    assert re.search(r"Onika is open at http://127\.0\.0\.1:\d+/\?key=\S+", capsys.readouterr().out)
    assert len(began) == 2


def test_options_reach_the_program(began, tmp_path):  # R-C20
    words = [
        "--port",
        "0",
        "--upper",
        "--presentation",
        "words",
        "--no-connect",
        "--no-diary",
        "--rtpu",
        "a",
        "--rtpu",
        "b",
        "--dictionary",
        "boxes",
        "--base",
        str(tmp_path),
    ]
    assert commands.carry_out(words) == 0
    site, options, _ = began[0]
    assert site.directories[0].path == tmp_path
    assert (options.is_connected, options.has_diary, options.rtpus) == (False, False, ("a", "b"))
    assert options.is_upper_only and options.presentation == "words"
    assert [path.name for path in options.dictionaries] == ["boxes"]


def test_a_dictionary_that_is_not_there_begins_nothing(began, capsys):  # R-D01
    assert commands.carry_out(["page", "--dictionary", "fruit"]) == 2
    assert "found fruit" in capsys.readouterr().err and began == []


def test_only_one_way_to_a_runtime_may_be_named(began, capsys):
    with pytest.raises(SystemExit):
        commands.carry_out(["page", "--connect", "ws://localhost:1", "--no-connect"])
    assert "found both" in capsys.readouterr().err


def test_a_port_that_is_taken_is_told_where_it_was_asked_for(began, capsys):
    with bound(0) as taken:
        taken.listen()
        with pytest.raises(SystemExit):
            commands.carry_out(["page", "--port", str(taken.getsockname()[1])])
    assert "expected a port that is free" in capsys.readouterr().err


def test_another_free_port_is_taken_where_none_was_asked_for(began, monkeypatch, capsys):
    with bound(0) as taken:
        taken.listen()
        monkeypatch.setattr(page, "PORT", taken.getsockname()[1])
        assert commands.carry_out(["page"]) == 0
        assert f":{taken.getsockname()[1]}/" not in capsys.readouterr().out


def test_a_browser_is_opened_where_there_is_a_screen(began, monkeypatch, capsys):
    opened = []
    monkeypatch.setattr(page.webbrowser, "open", opened.append)
    commands.carry_out(["page", "--port", "0"])
    monkeypatch.setenv("DISPLAY", ":0")
    commands.carry_out(["page", "--port", "0", "--no-browser"])
    assert opened == []
    capsys.readouterr()
    commands.carry_out(["page", "--port", "0"])
    (address,) = opened
    assert f"Onika is open at {address}" in capsys.readouterr().out


def test_state_is_kept_where_the_system_says(began, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    commands.carry_out(["page", "--port", "0"])
    assert began[0][2] == tmp_path / "onika"


@pytest.fixture
def state(monkeypatch, tmp_path):
    """A state directory that everybody may write to."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    (tmp_path / "onika").mkdir()
    (tmp_path / "onika").chmod(0o777)
    return tmp_path / "onika"


def test_a_state_directory_that_others_could_use_is_closed_and_that_is_told(began, state, capsys):  # R-X12
    assert commands.carry_out(["page", "--port", "0"]) == 0
    assert str(state) in capsys.readouterr().err
    assert state.stat().st_mode & 0o077 == 0
    assert commands.carry_out(["page", "--port", "0"]) == 0
    assert capsys.readouterr().err == ""


def test_a_state_directory_that_stays_open_to_others_is_not_used(began, state, monkeypatch, capsys):  # R-X12
    monkeypatch.setattr("pathlib.Path.chmod", lambda *_: None)
    assert commands.carry_out(["page", "--port", "0"]) == 2
    assert "cannot be mended" in capsys.readouterr().err
    assert began == []
    assert commands.carry_out(["doctor"]) in (0, 1)  # it keeps nothing


def test_stations_are_named_at_the_start_each_with_its_token(began, tmp_path):  # R-F02, R-C18
    token = tmp_path / "token"
    token.write_text("secret\n")
    token.chmod(0o600)
    words = ["--at", "cmu=wss://cmu.example", "--at", "sandia=wss://sandia.example:1", "--token-file", f"cmu={token}"]
    assert commands.carry_out([*words, "--no-browser"]) == 0
    stations = (("cmu", "wss://cmu.example:7994", "secret"), ("sandia", "wss://sandia.example:1", ""))
    assert (began[0][1].stations, began[0][1].token) == (stations, "")


@pytest.mark.parametrize(
    "words",
    [
        ["--at", "cmu"],
        ["--at", "here=wss://cmu.example"],
        ["--at", "cmu=http://cmu.example"],
        ["--at", "cmu=wss://a.example", "--at", "cmu=wss://b.example"],
        ["--token-file", "cmu=nowhere"],
    ],
)
def test_what_names_no_station_is_told(began, capsys, words):  # R-X01
    with pytest.raises(SystemExit):
        commands.carry_out([*words, "--no-browser"])
    assert "expected" in capsys.readouterr().err and not began


VISITS = "import sys, urllib.request; urllib.request.urlopen(sys.argv[1].removeprefix('--app=')).read()"


@pytest.fixture
def page_in_a_window(tmp_path):
    """The page, whose window a browser shows that is this program of Python."""

    def begun(browser):
        chromium = tmp_path / "bin" / "chromium"
        chromium.parent.mkdir()
        chromium.write_text(f'#!/bin/sh\nexec {sys.executable} -c "{browser}" "$@"\n')
        chromium.chmod(0o755)
        words = ("page", "--port", "0", "--no-connect", "--window", "900x700", "--ends-with-window")
        found = {"PATH": f"{chromium.parent}:{os.environ['PATH']}", "DISPLAY": ":0", "HOME": str(tmp_path)}
        command = [sys.executable, "-c", "from onika.cli import main; raise SystemExit(main())", *words]
        return subprocess.Popen(command, env={**os.environ, **found}, stdout=subprocess.PIPE, text=True)

    return begun


@pytest.mark.site
def test_the_page_ends_when_its_window_is_closed(page_in_a_window):  # R-H09
    program = page_in_a_window(VISITS)
    said, _ = program.communicate(timeout=60)
    assert "The window is closed" in said
    assert program.returncode in (0, 130)  # as after Ctrl-C: which one depends on what its tasks do just then


@pytest.mark.site
def test_a_browser_that_never_came_to_the_page_does_not_end_it(page_in_a_window):  # R-H09
    program = page_in_a_window("")
    with program, program.stdout:
        assert any("before it came to the page" in line for line in program.stdout)
        assert program.poll() is None
        program.terminate()


def test_only_a_window_can_be_waited_for(began, capsys):
    with pytest.raises(SystemExit):
        commands.carry_out(["page", "--ends-with-window"])
    assert "--window" in capsys.readouterr().err


LOADED = """
import sys
import onika.cli.page
print([name for name in ("numpy", "onika.desk.environment.environment", "onika.web.program") if name in sys.modules])
"""


def test_an_address_is_told_before_the_environment_is_loaded():  # R-X08
    done = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
