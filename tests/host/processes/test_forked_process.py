import os
import signal
import subprocess
import sys

import pytest

from onika.host.processes.forked_process import ForkedProcess


def sleeper():
    return ForkedProcess(os.posix_spawn(sys.executable, [sys.executable, "-c", "input()"], {}))


def test_its_end_is_seen_once_and_remembered():  # R-E10
    process = sleeper()
    with pytest.raises(subprocess.TimeoutExpired):
        process.wait(0.0)
    assert process.returncode is None
    process.kill()
    assert process.wait() == -signal.SIGKILL
    assert process.wait(0.0) == process.poll() == process.returncode == -signal.SIGKILL
    process.kill()  # its number may be somebody else's by now


def test_it_is_waited_for_until_it_ends_by_itself():
    pid = os.posix_spawn(sys.executable, [sys.executable, "-c", "raise SystemExit(3)"], {})
    assert ForkedProcess(pid).wait() == 3
