import pytest

from kit.runtime.process_sandbox import process_sandbox

SOURCE = """
import os, socket, subprocess, sys
from pathlib import Path
from onika.module import Module

HOME, SECRET = Path({home!r}), "ONIKA_SECRET"


class Tried(Module):
    def get(self, name):
        try:
            return getattr(self, "_" + name)()
        except RuntimeError as wrong:
            return str(wrong)

    def _home(self):
        return (HOME / "secret").read_text()

    def _leaves(self):
        return (HOME / "left").write_text("x")

    def _network(self):
        return socket.create_connection(("127.0.0.1", 9)) and 1

    def _program(self):
        return subprocess.run(["/bin/true"]).returncode

    def _environment(self):
        return os.environ.get(SECRET, "nothing")

    def _descriptors(self):
        found = []
        for number in range(3, 200):
            try:
                os.fstat(number)
                found.append(number)
            except OSError:
                pass
        return len(found)

    def _brought(self):
        return (Path(__file__).parent.parent / "net" / "weights").read_text()

    def _numbers(self):
        import numpy
        return float(numpy.linalg.solve(numpy.eye(3), numpy.ones(3)).sum())
"""


@pytest.fixture
def sandbox(tmp_path, monkeypatch):
    (tmp_path / "secret").write_text("nobody's business")
    monkeypatch.setenv("ONIKA_SECRET", "hidden")
    with process_sandbox(SOURCE.format(home=str(tmp_path))) as sandbox:
        yield sandbox


@pytest.mark.parametrize("what", ["home", "leaves", "network", "program"])
def test_what_is_outside_is_refused_in_words(sandbox, tmp_path, what):  # R-X16
    raised = sandbox.got(what).raised
    assert raised is not None
    assert "may only compute" in str(raised.why)
    assert not (tmp_path / "left").exists()


def test_it_has_nothing_open_but_its_own_and_no_secret(sandbox):  # R-X16
    assert sandbox.got("descriptors").value == 3  # its socket, and what it shares with its task, twice: once as a map
    assert sandbox.got("environment").value == "nothing"


def test_it_computes(sandbox):
    assert sandbox.got("numbers").value == 3.0
