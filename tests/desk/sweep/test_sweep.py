from threading import Lock

import pytest

from onika.desk.run.settings import RunSettings
from onika.desk.sweep import sweep as room
from onika.desk.sweep.case import CaseResult
from onika.desk.sweep.design import SweepDesign
from onika.desk.sweep.sweep import sweep

DESIGN = SweepDesign(RunSettings("stack", is_virtual=True), range(20))


class Runtimes:
    """All warm runtimes: how many there were, and which seeds came to them."""

    def __init__(self):
        self.lock = Lock()
        self.begun = self.ended = self.stopped = 0
        self.seeds = []
        self.breaks_at = None

    def __call__(self, prepared, site):
        return self

    def __enter__(self):
        with self.lock:
            self.begun += 1
        return self

    def __exit__(self, *_ending):
        with self.lock:
            self.ended += 1

    def end_at_once(self):
        self.stopped += 1

    def do(self, case, settings, limit_s):
        assert settings.seed == case.seed
        with self.lock:
            self.seeds.append(case.seed)
        if case.seed == self.breaks_at:
            raise RuntimeError("a fault of ours")
        return CaseResult(case, "completed")


@pytest.fixture
def runtimes(monkeypatch):
    runtimes = Runtimes()
    monkeypatch.setattr(room, "WarmRuntime", runtimes)
    return runtimes


@pytest.mark.parametrize("jobs", [1, 3, 50])
def test_each_case_is_done_once_by_no_more_runtimes_than_wished(runtimes, jobs):  # R-X23
    results = list(sweep(DESIGN, None, DESIGN.cases(), None, jobs))
    assert sorted(result.case.seed for result in results) == list(range(20)) == sorted(runtimes.seeds)
    assert runtimes.begun == runtimes.ended == min(jobs, 20)


def test_without_a_case_nothing_is_launched_for_long(runtimes):  # R-X23
    assert list(sweep(DESIGN, None, [], None, 4)) == []
    assert runtimes.seeds == []


def test_whoever_stops_listening_ends_it_and_every_runtime(runtimes):  # R-X23
    results = sweep(DESIGN, None, DESIGN.cases(), None, 1)
    next(results)
    results.close()
    assert runtimes.begun == runtimes.ended == runtimes.stopped == 1
    assert len(runtimes.seeds) <= 20


def test_a_fault_of_ours_is_raised_where_the_results_are_read(runtimes):  # R-X23
    runtimes.breaks_at = 3
    with pytest.raises(RuntimeError, match="a fault of ours"):
        list(sweep(DESIGN, None, DESIGN.cases(), None, 1))
    assert runtimes.begun == runtimes.ended
