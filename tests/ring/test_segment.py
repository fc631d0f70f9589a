"""Shared memory."""

import errno
import gc
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from onika.ring.segment import Segment, SharedMemoryRefused


def test_new_memory_is_zeroed_and_as_large_as_asked_for():
    segment = Segment.create("test", 5000)
    assert bytes(segment.view) == bytes(5000)
    segment.close()


def test_whoever_attaches_sees_the_same_bytes():  # R-A02
    segment = Segment.create("test", 64)
    other = Segment.attach(os.dup(segment.fd))
    segment.view[3] = 7
    assert (other.size, other.view[3]) == (64, 7)
    other.close()
    assert segment.view[3] == 7
    segment.close()


def test_the_memory_is_not_handed_to_programs_that_are_started():
    segment = Segment.create("test", 64)
    assert not os.get_inheritable(segment.fd)
    segment.close()


def test_nothing_is_left_behind_by_name():  # law 31
    segment = Segment.create("left-behind", 64)
    assert not list(Path("/dev/shm").glob("*left-behind*"))
    assert "memfd:onika-left-behind" in str(Path(f"/proc/self/fd/{segment.fd}").readlink())
    segment.close()


@pytest.mark.parametrize("user", [lambda view: view[4:8], lambda view: np.frombuffer(view, "B")], ids=["view", "array"])
def test_memory_that_is_still_read_stays_until_the_reader_goes(user):
    segment = Segment.create("test", 64)
    segment.view[:] = b"\7" * 64
    part = user(segment.view)
    segment.close()
    assert part[0] == 7
    with pytest.raises(OSError, match="Bad file descriptor"):
        os.fstat(segment.fd)


def test_a_segment_that_nobody_holds_any_more_leaves_no_descriptor_behind():
    segment = Segment.create("lost", 4096)
    fd = segment.fd
    del segment
    gc.collect()
    with pytest.raises(OSError, match="Bad file descriptor"):
        os.fstat(fd)


def test_a_copy_of_the_process_cannot_write_the_memory():  # R-X12
    script = """
import os, signal
from onika.ring.segment import Segment, SharedMemoryRefused
segment = Segment.create("test", 4096)
copy = os.fork()
if copy == 0:
    segment.view[0] = 7
    os._exit(0)
_, status = os.waitpid(copy, 0)
print(os.waitstatus_to_exitcode(status) == -signal.SIGSEGV, segment.view[0])
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout == "True 0\n"


def test_memory_that_the_system_refuses_is_told_and_leaves_no_descriptor(monkeypatch):  # R-B07, law 31
    def refuse(_descriptor, _size):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    before = len(list(Path("/proc/self/fd").iterdir()))
    monkeypatch.setattr(os, "ftruncate", refuse)
    with pytest.raises(SharedMemoryRefused, match="no more shared memory: no space is left"):
        Segment.create("test", 64)
    assert len(list(Path("/proc/self/fd").iterdir())) == before
