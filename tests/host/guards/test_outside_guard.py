import os
import subprocess
import sys

import pytest

pytestmark = pytest.mark.site

REACHES = (
    "open('there', 'w')",
    "os.open('there', os.O_RDWR)",
    "os.remove('there')",
    "subprocess.run(['true'])",
    "os.fork()",
    "socket.socket().connect(('127.0.0.1', 9))",
)
LEAVES_NO_TRACE = (
    f"open({os.devnull!r}, 'w')",
    "open(sys.executable, 'rb')",
    "subprocess.run([sys.executable, '-m', 'onika.host.none'], stderr=subprocess.DEVNULL)",  # a process of our own
)
PROGRAM = """
import os, socket, subprocess, sys
from onika.host.guards.outside_guard import OutsideRefused, stay_inside
stay_inside()
for line in sys.argv[1:]:
    try:
        eval(line)
    except OutsideRefused as refused:
        print(refused)
    else:
        print("done")
"""


def test_nothing_outside_is_touched_and_what_leaves_no_trace_is_done(tmp_path):  # R-E16
    words = [sys.executable, "-c", PROGRAM, *REACHES, *LEAVES_NO_TRACE]
    came = subprocess.run(words, capture_output=True, text=True, check=True, cwd=tmp_path).stdout.splitlines()
    assert all(line.startswith("a forecast touches nothing outside of it") for line in came[: len(REACHES)])
    assert came[len(REACHES) :] == ["done"] * len(LEAVES_NO_TRACE)
    assert list(tmp_path.iterdir()) == []
