"""A runtime that was started closed is opened to others at its console, and closed again (A16)."""

import re
import subprocess

import pytest

from kit.process.cli_process import ONIKA, CliProcess

pytestmark = pytest.mark.site


class Operator:
    """Somebody who types lines at the console of a runtime of his own."""

    def __init__(self):
        words = [*ONIKA, "runtime", "--virtual"]
        self.process = subprocess.Popen(
            words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )

    def types(self, line, until):
        """The first group of what the console says to it."""
        self.process.stdin.write(f"{line}\n")
        self.process.stdin.flush()
        output = ""
        while (said := self.process.stdout.readline()) != "":
            output += said
            if match := re.search(until, said):
                return match[match.lastindex or 0]
        raise AssertionError(f"expected {until} after {line}, found {output}")

    def ends(self):
        self.process.stdin.close()
        self.process.stdout.read()
        return self.process.wait(30)


@pytest.fixture
def operator(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    operator = Operator()
    yield operator
    operator.process.kill()
    operator.process.wait()
    operator.process.stdout.close()


def comes(tmp_path, address, line, **environment):
    """Somebody else comes with a line; whether it was carried out, and what was said."""
    script = tmp_path / "line"
    script.write_text(f"{line}\n", encoding="utf-8")
    with CliProcess("console", address, "--script", str(script), "--no-console", environment=environment) as console:
        return console.code(), console.text()


def test_it_is_closed_then_open_then_closed_to_others(tmp_path, operator):  # R-A16, R-F01
    address = operator.types("listen 127.0.0.1:0", r"others reach this runtime at (\S+)")
    token = operator.types("echo", r"as viewer with the token (\S+), which is told only now")
    code, output = comes(tmp_path, address, "spawn puma")
    assert code == 0, output  # the same user comes in as its owner
    code, output = comes(tmp_path, address, "open")
    assert (code, f"others reach this runtime at {address}" in output) == (0, True), output
    code, output = comes(tmp_path, address, "kill puma", ONIKA_TOKEN=token)
    assert code != 0, output
    assert "viewer" in output
    assert comes(tmp_path, address, "close", ONIKA_TOKEN=token)[0] != 0
    code, output = comes(tmp_path, address, "subsystems", ONIKA_TOKEN="wrong")
    assert code != 0, output
    operator.types("close", "nobody else reaches this runtime any more")
    assert comes(tmp_path, address, "subsystems")[0] != 0
    again = operator.types("listen 127.0.0.1:0", r"others reach this runtime at (\S+)")
    code, output = comes(tmp_path, again, "subsystems", ONIKA_TOKEN=token)
    assert code != 0, output  # the token was that of the other opening
    assert comes(tmp_path, again, "subsystems")[0] == 0
    assert operator.ends() == 0
