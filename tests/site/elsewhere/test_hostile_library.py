"""A library of somebody whose key was trusted, and who means no good: its code computes, and reaches nothing."""

import pytest

from kit.labs.laboratory import Laboratory, job
from kit.labs.library_site import LibrarySite, wink
from kit.process.cli_process import CliProcess
from onika.cli import main
from onika.store.remote.publication import fingerprint_of

CODE = '''"""Winks, and tries what it may not."""

import os
import socket
import subprocess
from pathlib import Path

from onika.module import Module, OutVar, finish

HOME = Path({home!r})


def succeeds(do):
    try:
        do()
    except (OSError, RuntimeError):
        return 0
    return 1


def tries():
    """How much of it can be done."""
    return sum(map(succeeds, [
        lambda: (HOME / "secret").read_text(),
        lambda: (HOME / "left").write_text("here"),
        lambda: socket.create_server(("127.0.0.1", 0)).close(),
        lambda: subprocess.run(["/bin/true"], check=True),
        lambda: os.kill(os.getppid(), 0),
        lambda: Path("/proc/1/maps").read_bytes() and Path("/proc/self/fd").iterdir().__next__(),
    ]))


AT_IMPORT = tries()


class Wink(Module):
    """Winks."""

    trigger = True
    LAMP = OutVar("int", "-", "how much could be done")

    def cycle(self):
        self.LAMP = AT_IMPORT + tries()
        {also}
        return finish()
'''


@pytest.fixture
def site(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    (tmp_path / "home").mkdir()
    (tmp_path / "home" / "secret").write_text("nobody's business")
    site = LibrarySite(tmp_path)
    site.write("module/wink.rmod", wink())
    Laboratory(site.base).configuration("winkC", "wink 50")
    Laboratory(site.base).application("evening", [job("winkC")])
    return site


def taken(site, tmp_path, also="pass"):
    """The library with this code is trusted and used."""
    site.write("module/wink.py", CODE.format(home=str(tmp_path / "home"), also=also))
    assert main(["library", "publish", str(site.base), "--to", str(site.folder), "--key", str(site.key)]) == 0
    assert main(["library", "add", str(site.folder), "--trust", str(fingerprint_of(site.key.with_suffix(".pub")))]) == 0


@pytest.mark.parametrize("clock", [["--virtual"], []])
def test_its_code_runs_and_reaches_nothing(site, tmp_path, clock):  # R-X16
    taken(site, tmp_path)
    assert main(["run", "evening", *clock, "--expect", "LAMP == 0"]) == 0
    assert not (tmp_path / "home" / "left").exists()


def test_who_gives_it_all_rights_gives_it_all_rights(site, tmp_path, capsys):  # R-X16
    taken(site, tmp_path)
    assert main(["library", "rights", "wings", "all"]) == 0
    assert "may do all that you may" in capsys.readouterr().out
    assert main(["run", "evening", "--virtual", "--expect", "LAMP >= 8"]) == 0
    assert (tmp_path / "home" / "left").exists()
    assert main(["library", "list"]) == 0
    assert "all rights" in capsys.readouterr().out
    (tmp_path / "home" / "left").unlink()
    assert main(["library", "rights", "wings", "compute"]) == 0
    assert main(["run", "evening", "--virtual", "--expect", "LAMP == 0"]) == 0
    assert not (tmp_path / "home" / "left").exists()


@pytest.mark.parametrize(
    ("also", "words"),
    [
        ("while True: pass", "did not come back within"),
        ("os._exit(0)", "has ended"),
        ("open(HOME / 'secret')", "may only compute"),
        ("os.kill(os.getpid(), 9)", "has ended"),
    ],
)
@pytest.mark.parametrize("clock", [["--virtual"], []])
def test_what_it_does_to_itself_is_told_and_harms_nobody_else(site, tmp_path, capsys, clock, also, words):  # R-X16
    taken(site, tmp_path, also)
    capsys.readouterr()
    assert main(["run", "evening", *clock]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert words in said
    assert "wink" in said


def test_whoever_prints_the_loop_of_a_job_runs_nothing_of_it(site, tmp_path, capsys):  # R-X16
    taken(site, tmp_path)
    assert main(["run", "evening", "--virtual"]) == 0  # fetches the code
    assert main(["doctor", "--sweep", "winkC"]) == 2
    assert "library of others" in capsys.readouterr().err
    assert not (tmp_path / "home" / "left").exists()


BY_HAND = """
spawn all of jmoveC
on puma
on diff
spawn wink
on wink
wait wink off within 5
read LAMP
swap wink
on wink
wait wink off within 5
status
check
kill wink
tasks
quit
"""


@pytest.mark.parametrize("clock", [["--virtual"], []])
def test_its_task_joins_what_runs_by_hand_and_its_code_is_exchanged(site, tmp_path, clock):  # R-F03, R-X16, R-C12
    taken(site, tmp_path)
    assert main(["library", "fetch"]) == 0
    script = tmp_path / "script"
    script.write_text(BY_HAND)
    with CliProcess("runtime", "--no-fifo", "--no-console", "--script", str(script), *clock) as console:
        output = console.text()
        assert console.code() == 0, output
    assert "LAMP = 0" in output
    assert "the memory of variables is sound" in output
    assert not (tmp_path / "home" / "left").exists()
