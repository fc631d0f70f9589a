"""A process beside a loop that waits for nothing."""

import os
import select
import socket
import time

from onika.workcell.filmed.begun_process import BegunProcess


def ended(end):
    """What was said before the other end was gone."""
    said = b""
    with end:
        while select.select([end], [], [], 20.0)[0] and (more := end.recv(100)):
            said += more
    return said


def begun(words):
    """With the end of a socket of which the other one is with the process."""
    ours, theirs = socket.socketpair()
    process = BegunProcess("timeit", words(theirs.fileno()), (theirs.fileno(),), {**os.environ, "WORD": "heard"})
    theirs.close()
    return process, ours


def test_it_has_its_descriptors_and_its_environment():  # R-F05
    script = "import os; os.write({}, os.environ['WORD'].encode())"
    process, ours = begun(lambda number: ("-n", "1", "-r", "1", script.format(number)))
    assert ended(ours) == b"heard"
    process.end()


def test_it_is_ended_without_a_wait_and_leaves_nothing():  # R-F05, law 16
    process, ours = begun(lambda _: ("-n", "1", "-r", "1", "import time; time.sleep(60)"))
    process.end()
    assert ended(ours) == b""
    until = time.monotonic() + 20.0
    while time.monotonic() < until:
        try:
            os.kill(process.pid, 0)
        except ProcessLookupError:
            return
    raise AssertionError("the process is still there")


def test_what_takes_long_is_done_there_before_it_becomes_a_program():  # R-F05, law 16
    ours, theirs = socket.socketpair()
    done = []

    def before():
        done.append(theirs.send(b"before "))

    script = f"import os; os.write({theirs.fileno()}, b'then')"
    process = BegunProcess("timeit", ("-n", "1", "-r", "1", script), (theirs.fileno(),), os.environ, before)
    theirs.close()
    assert ended(ours) == b"before then" and done == []
    process.end()
