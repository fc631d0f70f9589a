import os
import signal
from functools import partial
from itertools import pairwise

import pytest
from distributed import LocalCluster

from onika.desk.plan.preparation import PreparedRun, prepare_run
from onika.desk.run.settings import RunSettings
from onika.desk.sweep import cluster as room, cluster_work
from onika.desk.sweep.case import CaseResult
from onika.desk.sweep.cluster import NoCluster, cluster_sweep
from onika.desk.sweep.cluster_work import KeptRuntimes
from onika.desk.sweep.design import SweepDesign
from onika.desk.sweep.sweep import sweep
from onika.desk.sweep.swept_program import SweptProgram
from onika.store.site import open_site
from onika.wire.plan import Plan

SITE = open_site([], {}, None)
DESIGN = SweepDesign(RunSettings("stack", is_virtual=True), range(20))
PROGRAM = SweptProgram.of(DESIGN, PreparedRun("stack", None, Plan("stack", (), ()), (), ()))
local = partial(LocalCluster, n_workers=1, threads_per_worker=2, dashboard_address=None)


class Runtime:
    def __init__(self, prepared, site):
        pass

    def do(self, case, settings, limit_s):
        return CaseResult(case, "completed", hash=f"{case.seed}")

    def close(self):
        pass


@pytest.fixture(scope="module")
def address():
    with local(processes=False, protocol="tcp") as cluster:
        yield cluster.scheduler_address


@pytest.fixture
def _quick(monkeypatch):
    monkeypatch.setattr(cluster_work, "WarmRuntime", Runtime)
    monkeypatch.setattr(cluster_work, "_kept", KeptRuntimes())


@pytest.mark.usefixtures("_quick")
@pytest.mark.parametrize("jobs", [0, 1, 50])
def test_each_case_is_done_once_by_the_workers(address, jobs):  # R-X23
    results = list(cluster_sweep(PROGRAM, DESIGN.cases(), address, jobs))
    assert sorted(result.case.seed for result in results) == list(range(20))
    assert all(result.hash == f"{result.case.seed}" for result in results)


@pytest.mark.usefixtures("_quick")
def test_whoever_stops_listening_ends_it(address):  # R-X23
    results = cluster_sweep(PROGRAM, DESIGN.cases(), address, 2)
    next(results)
    results.close()
    assert len(list(cluster_sweep(PROGRAM, DESIGN.cases(), address, 2))) == 20


@pytest.mark.usefixtures("_quick")
def test_a_worker_with_other_code_ends_the_sweep_and_is_named(address, monkeypatch):  # R-X23
    monkeypatch.setattr(room, "own_build", lambda: "mine")
    with pytest.raises(NoCluster) as refused:
        list(cluster_sweep(PROGRAM, DESIGN.cases(), address, 0))
    (reason,) = refused.value.args
    assert reason.key == "sweep.other_build"
    assert reason.args["here"] == "mine"


@pytest.mark.parametrize("nowhere", ["tcp://127.0.0.1:1", "127.0.0.1", "nothing://a:1"])
def test_where_there_is_no_cluster_it_is_told(nowhere, monkeypatch):  # R-X23
    monkeypatch.setattr(room, "_PATIENCE_S", 0.2)
    with pytest.raises(NoCluster) as refused:
        list(cluster_sweep(PROGRAM, DESIGN.cases(), nowhere, 0))
    assert refused.value.args[0].key == "sweep.no_cluster"


@pytest.mark.slow
def test_workers_that_are_killed_lose_nothing_and_change_nothing():  # R-X23
    design = SweepDesign(RunSettings("go_home", is_virtual=True, has_black_box=False), range(200))
    prepared = prepare_run("go_home", SITE)
    with local(n_workers=2, threads_per_worker=1, processes=True) as cluster:
        results, blows = {}, iter((20, 60, 100, 140))
        at = next(blows)
        for result in cluster_sweep(SweptProgram.of(design, prepared), design.cases(), cluster.scheduler_address, 0):
            results[result.case.seed] = result
            if len(results) == at:
                workers = [nanny.process.pid for nanny in cluster.workers.values() if nanny.process is not None]
                os.kill(workers[at % len(workers)], signal.SIGKILL)
                at = next(blows, 0)
    alone = {result.case.seed: result for result in sweep(design, prepared, design.cases(), SITE, 2)}
    assert results == alone
    assert len(results) == 200
    assert any(one.hash != other.hash for one, other in pairwise(alone.values()))
