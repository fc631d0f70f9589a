"""A synchronous task in a real run: it runs on its events, in wall and in virtual time."""

import json

import pytest

from kit.labs.laboratory import Laboratory, job
from onika.cli import main

ECHO = """
import os
from onika.module import Module, OutVar

class Echo(Module):
    N = OutVar("int", "-", "events heard")

    def on(self, inputs):
        self._in, self._out = os.pipe()
        os.write(self._out, b"x")

    def fileno(self):
        return self._in

    def sync(self):
        os.read(self._in, 1)
        self.N += 1
        if self.N < 5:
            os.write(self._out, b"x")

    def off(self):
        os.close(self._in)
        os.close(self._out)
"""

ENOUGH = """
from onika.module import InVar, Module, finish

class Enough(Module):
    trigger = True
    N = InVar("int", "-", "events heard")

    def cycle(self):
        return finish() if self.N >= 5 else None
"""


@pytest.mark.site
@pytest.mark.parametrize("mode", [[], ["--virtual"]])
def test_a_synchronous_task_runs_once_for_each_event(capsys, tmp_path, mode):  # R-A04
    laboratory = Laboratory(tmp_path)
    laboratory.module("echo", ECHO)
    laboratory.module("enough", ENOUGH)
    laboratory.plain_task("echo", writes="N")
    echo = tmp_path / "module" / "echo.rmod"
    echo.write_text(echo.read_text().replace("periodic", "synchronous"))
    laboratory.plain_task("enough", reads="N")
    laboratory.configuration("echoC", "echo 100", "enough 100")
    path = laboratory.application("echoes", [job("echoC")])
    assert main(["run", str(path), *mode, "--json", "--expect", "N == 5"]) == 0
    assert json.loads(capsys.readouterr().out.splitlines()[-1])["state"] == "completed"
