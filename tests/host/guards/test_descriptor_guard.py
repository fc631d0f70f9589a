import os

import pytest

from onika.host.guards.code_watch import GAVE_UP
from onika.host.guards.descriptor_guard import DescriptorGuard


class Process:
    """A process with a pipe as its way to the runtime."""

    def __init__(self):
        self.way, self._other = os.pipe()
        self.noted, self.said, self.codes = [], [], []
        self.guard = DescriptorGuard(self.way, self.noted.append, self.said.append, self.codes.append)

    def close(self):
        for descriptor in (self.way, self._other):
            try:
                os.close(descriptor)
            except OSError:
                assert descriptor == self.way


@pytest.fixture
def process():
    process = Process()
    yield process
    process.close()


def nowhere(way):
    """Put another file in a descriptor's place."""
    other = os.open(os.devnull, os.O_RDWR)
    os.dup2(other, way)
    os.close(other)


def test_whose_code_runs_is_passed_on(process):  # law 15
    for task in ("flow0/a", "flow0/b", ""):
        process.guard.watch(task)
    assert process.noted == ["flow0/a", "flow0/b", ""]
    assert (process.said, process.codes) == ([], [])


@pytest.mark.parametrize("blow", [os.close, nowhere])
def test_the_task_whose_code_closed_or_exchanged_the_descriptor_is_named(process, blow):  # law 30
    process.guard.watch("flow0/a")
    process.guard.watch("flow0/sick")
    blow(process.way)
    process.guard.watch("flow0/b")
    assert [str(reason) for reason in process.said] == ["task flow0/sick has closed descriptors of its process"]
    assert process.codes == [GAVE_UP]
