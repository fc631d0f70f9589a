import gc
import os
import subprocess
import sys

import pytest

from onika.host.processes import realtime_scheduling


@pytest.fixture
def collecting():
    """Garbage is collected again afterwards."""
    yield
    gc.unfreeze()
    gc.enable()


def test_no_garbage_is_collected_while_tasks_cycle(collecting):  # law 21
    realtime_scheduling.still_garbage()
    assert not gc.isenabled()
    assert gc.get_freeze_count() > 0


def test_what_is_refused_is_told_and_not_raised(monkeypatch):  # law 31
    def refuse(*_given):
        raise PermissionError

    monkeypatch.setattr(os, "sched_setscheduler", refuse)
    assert realtime_scheduling.first_in_first_out() is False


def test_a_process_takes_what_is_granted_and_says_so():  # law 31
    code = (
        "from onika.host.processes.realtime_scheduling import become_real_time\n"
        "import gc, os\n"
        "granted = become_real_time(False)\n"
        "print(sorted(granted), granted['SCHED_FIFO'], gc.isenabled(), os.sched_getscheduler(0) == os.SCHED_OTHER)\n"
    )
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()
    assert output == "['SCHED_FIFO', 'memory lock', 'timer slack'] False False True"


def test_the_real_time_class_is_what_the_operating_system_says():  # law 31
    code = (
        "from onika.host.processes.realtime_scheduling import first_in_first_out\n"
        "import os\n"
        "print(first_in_first_out() == bool(os.sched_getscheduler(0) & os.SCHED_FIFO))\n"
    )
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()
    assert output == "True"
