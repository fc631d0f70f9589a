import os
import signal
import sys

import pytest

from onika.link.carrier import wait_for
from onika.link.child import runtime_process
from onika.link.child.launcher import launch


def command(text):
    return (sys.executable, "-c", text)


def test_a_runtime_that_does_not_end_is_killed_and_leaves_no_zombie():
    text = "import signal, time\nsignal.signal(signal.SIGTERM, signal.SIG_IGN)\nwhile True: time.sleep(60)"
    child = launch([], command(text))
    assert child.wait(0.01) is None
    assert child.close(grace_s=0.01) == -signal.SIGKILL
    with pytest.raises(ProcessLookupError):
        os.kill(child.pid, 0)


def test_a_runtime_can_be_asked_to_end():
    with launch([], command("import time\nprint('up', flush=True)\ntime.sleep(600)")) as child:
        while child.tail() != "up\n":
            wait_for([child.carrier], 0.01)
        child.terminate()
        assert child.wait(60) == -signal.SIGTERM


def test_a_guard_is_waited_for_while_it_begins_however_quickly_it_has_to_end(monkeypatch):  # R-X12, R-X25
    monkeypatch.setattr(runtime_process, "_GUARD_S", 0.0)
    with launch([], command("import time\ntime.sleep(600)")) as child:
        assert child.alive()
        os.kill(child.pid, 0)
