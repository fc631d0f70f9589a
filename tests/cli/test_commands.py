import subprocess
import sys
from io import TextIOWrapper
from pathlib import Path

import pytest

from onika import __version__
from onika.cli.commands import carry_out


def test_the_version_is_said(capsys):
    with pytest.raises(SystemExit) as ended:
        carry_out(["--version"])
    assert ended.value.code == 0
    assert __version__ in capsys.readouterr().out


@pytest.mark.parametrize("words", [["dance"], ["dance", "--port", "1"]])
def test_a_command_that_is_none_is_refused_with_those_there_are(words, capsys):
    with pytest.raises(SystemExit) as ended:
        carry_out(words)
    assert ended.value.code == 2
    assert capsys.readouterr().err


def test_every_command_describes_itself(capsys):
    with pytest.raises(SystemExit):
        carry_out(["--help"])
    shown = capsys.readouterr().out
    for command in ("page", "run", "check", "new", "doctor"):
        assert command in shown


@pytest.mark.parametrize("words", [["--help"], ["recording", "--help"]])
def test_help_that_cannot_be_written_is_a_failure(words, capsys, monkeypatch):
    with Path("/dev/full").open("wb", buffering=0) as full:
        monkeypatch.setattr("sys.stdout", TextIOWrapper(full, write_through=True))
        monkeypatch.setattr("onika.cli.commands._drop_output", lambda: None)
        assert carry_out(words) == 1
    assert "no space" in capsys.readouterr().err


LEAD_NOWHERE = """
import os
for number in range(3):
    os.close(number)
from onika.cli import main
try:
    main(["--version"])
except SystemExit:
    os._exit(0 if {os.readlink(f"/proc/self/fd/{number}") for number in range(3)} == {"/dev/null"} else 1)
"""


def test_a_program_that_is_started_without_input_and_outputs_has_them_lead_nowhere():  # R-A15
    assert subprocess.run([sys.executable, "-c", LEAD_NOWHERE], check=False).returncode == 0
