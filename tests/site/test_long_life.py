"""A runtime that lives long: after every run it holds as many descriptors and segments as before."""

from pathlib import Path
from time import monotonic

import pytest

from kit.labs.laboratory import Laboratory, job
from onika.desk.plan.preparation import prepare_run
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.store.site import open_site
from onika.wire import event, request

pytestmark = pytest.mark.site

WALL_S = 3600.0
RECONFIGURATIONS = 5000
STEPS = 50
GROWTH_KB = 4096
"""How much more memory a process may take after an hour than when it was warm."""
WARM = 0.25
"""The part of the hour after which it is warm: what is kept for looking back has grown to its bound."""
LATE = ("runtime.device_silent", "runtime.drive_tripped")
"""What a run ends with where the machine had no time for its devices."""


class LongLife:
    """One runtime, in which an application is run again and again."""

    def __init__(self, folder, steps, *, is_virtual=False):
        laboratory = Laboratory(folder)
        jobs = [job("opengripC"), job("closegripC")] * (steps // 2) or [job("opengripC")]
        self.recording = folder / "run.mcap"
        self._prepared = prepare_run(str(laboratory.application("again", jobs)), open_site([folder], {}, None))
        assert self._prepared.plan is not None, self._prepared.faults
        self._runtime = LaunchedRuntime(("rt0",), is_virtual)

    def __enter__(self):
        self._runtime.__enter__()
        return self

    def __exit__(self, *wrong):
        self._runtime.__exit__(*wrong)

    def run(self):
        """One run, recorded over the last one, to its end; one that the machine was too late for counts too."""
        self._runtime.ask(request.Prepare(self._prepared.plan, self._prepared.targets))
        answer = self._runtime.ask(request.Begin(record=str(self.recording)))
        assert isinstance(answer, request.Done), answer
        while True:
            for message in self._runtime.events(0.2):
                if isinstance(message, event.Result):
                    assert message.completed or any(key in repr(message.cause) for key in LATE), message
                    return

    def holdings(self):
        """Of every process: its descriptors, and how many of them and of its mappings are shared memory of ours."""
        self._runtime.ask(request.Snapshot())  # until this is answered, what the run has left is being cleared
        return {words: holding(pid) for pid, words in self.processes().items()}

    def settled(self):
        """What is held once nothing is cleared any more: the same for a whole second."""
        held, since = self.holdings(), monotonic()
        while monotonic() < since + 1.0:
            if (now := self.holdings()) != held:
                held, since = now, monotonic()
        return held

    def comes_back_to(self, holdings, patience_s=20.0):
        """Whether it holds the same again, as soon as what the run has left is cleared."""
        until = monotonic() + patience_s
        while (held := self.holdings()) != holdings and monotonic() < until:
            pass
        return held == holdings or held

    def memory_kb(self):
        """Of every process."""
        return {words: memory_kb(pid) for pid, words in self.processes().items()}

    def processes(self):
        pids = [self._runtime.pid, *below(self._runtime.pid)]
        return {pid: Path(f"/proc/{pid}/cmdline").read_text().replace("\0", " ").split(" --")[0] for pid in pids}


def below(pid):
    """All living processes that come from this one."""
    parents = {}
    for path in Path("/proc").glob("[0-9]*"):
        try:
            state, parent = (path / "stat").read_text().rpartition(")")[2].split()[:2]
        except OSError:
            continue
        if state != "Z":
            parents[int(path.name)] = int(parent)
    found = {pid}
    while new := {child for child, parent in parents.items() if parent in found} - found:
        found |= new
    return sorted(found - {pid})


def holding(pid):
    files = []
    for path in Path(f"/proc/{pid}/fd").iterdir():
        try:
            files.append(str(path.readlink()))
        except OSError:
            continue
    maps = Path(f"/proc/{pid}/maps").read_text().splitlines()
    return len(files), sum("memfd:onika" in name for name in files), sum("memfd:onika" in line for line in maps)


def memory_kb(pid):
    lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS"))


@pytest.mark.parametrize("is_virtual", [False, True], ids=["wall", "virtual"])
def test_a_run_leaves_no_descriptor_and_no_segment(tmp_path, is_virtual):  # R-F01, R-X05
    with LongLife(tmp_path, 1, is_virtual=is_virtual) as life:
        life.run()
        first = life.settled()
        for _ in range(2):
            life.run()
            assert life.comes_back_to(first) is True


@pytest.mark.slow
def test_an_hour_of_runs_and_thousands_of_reconfigurations_are_bounded(tmp_path):  # R-F01, R-X05
    began, steps = monotonic(), 0
    memory = None
    with LongLife(tmp_path, STEPS) as life:
        for _ in range(3):
            life.run()
        holdings, size = life.settled(), life.recording.stat().st_size
        while monotonic() < began + WALL_S or steps < RECONFIGURATIONS:
            life.run()
            steps += STEPS
            assert life.comes_back_to(holdings) is True
            assert life.recording.stat().st_size < 2 * size
            if memory is None and monotonic() > began + WARM * WALL_S:
                memory = life.memory_kb()
        grown = {words: kb - memory[words] for words, kb in life.memory_kb().items()}
    assert all(kb < GROWTH_KB for kb in grown.values()), grown
