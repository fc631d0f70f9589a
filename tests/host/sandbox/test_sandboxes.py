import os
from contextlib import closing, suppress

import pytest

from kit.runtime.executive_rig import ExecutiveRig
from onika.host.sandbox import sandboxes as room
from onika.host.sandbox.sandboxes import Sandboxes
from onika.process import confinement

SOURCE = """
from onika.module import Module, OutVar

class Tried(Module):
    Q = OutVar("double[100000]", "-", "a long one")
"""


@pytest.fixture
def sandboxes():
    with closing(Sandboxes()) as sandboxes:
        yield sandboxes


def spawn():
    return ExecutiveRig().spawn_of("tried", SOURCE.replace("100000", "1000"))


def test_the_memory_has_room_for_what_the_task_has(sandboxes):
    begun = sandboxes.begin(ExecutiveRig().spawn_of("tried", SOURCE.replace("100000", "10000")))
    assert begun.memory.size >= 4 * 8 * 10000
    begun.close()


def test_those_of_a_unit_end_with_it(sandboxes):  # R-X16
    gone, stays = sandboxes.begin(spawn(), "rt0"), sandboxes.begin(spawn(), "rt1")
    sandboxes.end_of("rt0")
    gone.post.settimeout(20.0)
    stays.post.settimeout(20.0)
    assert b"Declared" in stays.post.recv(1 << 16)
    with suppress(ConnectionResetError):
        while gone.post.recv(1 << 16):
            pass  # what it said before
    for begun in (gone, stays):
        begun.close()


def test_who_closes_the_socket_ends_the_process(sandboxes):
    begun = sandboxes.begin(spawn())
    process = os.dup(begun.process)
    begun.close()
    assert os.waitid(os.P_PIDFD, process, os.WEXITED | os.WNOWAIT) is not None
    os.close(process)
    sandboxes.bury()


def test_where_nothing_can_be_confined_no_module_of_others_runs(sandboxes, monkeypatch):  # R-X16
    monkeypatch.setattr(confinement, "level", lambda: 0)
    with pytest.raises(ValueError, match="cannot confine a module of others"):
        sandboxes.begin(spawn())


def test_where_no_process_can_be_begun_it_is_said(sandboxes, monkeypatch):
    def refuse(*_given, **_named):
        raise OSError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(room, "start", refuse)
    with pytest.raises(ValueError, match="temporarily unavailable"):
        sandboxes.begin(spawn())
