import os
import signal
from pathlib import Path

from onika.host.processes.forked_work import ForkedWork


def test_a_copy_works_it_out_and_only_its_bytes_are_left():  # law 16
    seen = []
    whose = os.getpid()

    def work():
        seen.append(1)
        return f"{os.getppid() == whose} {len(seen)}".encode() + bytes(200_000)

    assert ForkedWork(work).wait() == b"True 1" + bytes(200_000)
    assert seen == []


def test_what_comes_to_nothing_or_is_ended_gives_nothing(capfd):  # law 16
    def fails():
        raise ValueError("expected a model, found none")

    def breaks():
        raise KeyError("a fault of ours")

    assert ForkedWork(fails).wait() is None and capfd.readouterr().err == ""
    assert ForkedWork(breaks).wait() is None and "a fault of ours" in capfd.readouterr().err
    assert ForkedWork(lambda: os.kill(os.getpid(), signal.SIGKILL)).wait() is None


def test_a_copy_holds_nothing_open_that_this_process_has():  # law 31
    ours, theirs = os.pipe()
    work = ForkedWork(lambda: " ".join(path.name for path in Path("/proc/self/fd").iterdir()).encode())
    held = {int(number) for number in (work.wait() or b"").split()}
    assert held and not held & {ours, theirs}
    os.close(ours)
    os.close(theirs)
