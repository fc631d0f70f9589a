"""The command is there as a module of Python, too."""

import runpy
import sys

import pytest

import onika


def test_python_carries_out_the_command(monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["onika", "--version"])
    with pytest.raises(SystemExit) as ended:
        runpy.run_module("onika.cli", run_name="__main__")
    assert ended.value.code == 0
    assert onika.__version__ in capsys.readouterr().out
