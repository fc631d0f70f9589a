import json
import platform
import subprocess
import sys

import pytest

from onika.process import system_calls

CHILD = """
import ctypes, fcntl, json, os, signal, socket, sys, threading
from pathlib import Path
from onika.process import system_calls

path = Path(sys.argv[1])
own, theirs = socket.socketpair()
system_calls.leave_only_computing()


def tried(do):
    try:
        do()
    except (OSError, RuntimeError) as wrong:
        return type(wrong).__name__
    return "done"


def call(number, *given):
    library = ctypes.CDLL(None, use_errno=True)
    if library.syscall(number, *given) < 0:
        raise OSError(ctypes.get_errno(), "refused")


print(json.dumps({
    "reads": tried(lambda: (path / "text").read_text()),
    "sends to what is open": tried(lambda: own.send(b"x")),
    "maps memory": tried(lambda: bytearray(1 << 24)),
    "asks of a descriptor": tried(lambda: fcntl.fcntl(own, fcntl.F_GETFD)),
    "has its own time": tried(lambda: __import__("time").sleep(0.001)),
    "opens a socket": tried(lambda: socket.socket(socket.AF_UNIX)),
    "begins a process": tried(os.fork),
    "begins a thread": tried(lambda: threading.Thread(target=print).start()),
    "becomes another program": tried(lambda: os.execv("/bin/true", ["true"])),
    "signals another": tried(lambda: os.kill(1, 0)),
    "makes a folder": tried(lambda: os.mkdir(path / "made")),
    "removes a file": tried(lambda: os.unlink(path / "text")),
    "makes a file longer": tried(lambda: os.truncate(path / "text", 100)),
    "looks into another": tried(lambda: call(101 if os.uname().machine == "x86_64" else 117, 16, 1, 0, 0)),
    "takes another's descriptor": tried(lambda: call(438, 3, 0, 0)),
    "has another signalled": tried(lambda: fcntl.fcntl(own, fcntl.F_SETOWN, 1)),
    "chooses the signal": tried(lambda: fcntl.fcntl(own, fcntl.F_SETSIG, 9)),
    "opens a ring": tried(lambda: call(425, 1, 0)),
}), flush=True)
if len(sys.argv) > 2:
    os.kill(os.getpid(), signal.SIGTERM)
"""


@pytest.fixture(scope="module")
def outcome(tmp_path_factory):
    folder = tmp_path_factory.mktemp("folder")
    (folder / "text").write_text("text")
    words = [sys.executable, "-c", CHILD, str(folder)]
    said = subprocess.run(words, capture_output=True, text=True, timeout=60, check=False)
    assert not said.returncode, said.stderr
    return json.loads(said.stdout)


def test_a_process_that_only_computes_reads_sends_and_maps_memory(outcome):  # R-X16
    assert {name for name, what in outcome.items() if what == "done"} == {
        "reads", "sends to what is open", "maps memory", "asks of a descriptor", "has its own time",
    }  # fmt: skip


def test_it_begins_nothing_opens_no_socket_and_touches_no_other_process(outcome):  # R-X16
    assert len([what for what in outcome.values() if what in ("PermissionError", "RuntimeError")]) == 13


def test_it_may_end_itself(tmp_path):
    (tmp_path / "text").write_text("text")
    words = [sys.executable, "-c", CHILD, str(tmp_path), "ends"]
    assert subprocess.run(words, capture_output=True, timeout=60, check=False).returncode == -15


def test_where_the_calls_of_a_machine_are_not_known_nothing_is_left_out(monkeypatch):  # R-X16
    assert system_calls.can_be_left_out()
    monkeypatch.setattr(platform, "machine", lambda: "riscv64")
    assert not system_calls.can_be_left_out()
    with pytest.raises(OSError, match="riscv64"):
        system_calls.leave_only_computing()
