"""Does a sweep: its runs on as many warm runtimes as wished, each result kept as it comes (requirement X23)."""

from collections.abc import Iterable, Iterator
from queue import SimpleQueue
from threading import Thread

from onika.desk.plan.preparation import PreparedRun
from onika.desk.sweep.case import Case, CaseResult
from onika.desk.sweep.design import SweepDesign
from onika.desk.sweep.warm_runtime import WarmRuntime
from onika.store.site import Site

LONGEST_S = 3600.0
"""How much virtual time a run may take where nothing else is said."""


def sweep(
    design: SweepDesign, prepared: PreparedRun, cases: Iterable[Case], site: Site, jobs: int
) -> Iterator[CaseResult]:
    """Do these cases, so many at a time; each result as soon as it is there, in any order.

    prepared   the application of the design
    site       where the task is sought that could stand for one that is refused

    Whoever stops listening ends it at once: what is under way then is lost.
    """
    waiting: SimpleQueue[Case | None] = SimpleQueue()
    done: SimpleQueue[CaseResult | BaseException | None] = SimpleQueue()
    count = 0
    for case in cases:
        waiting.put(case)
        count += 1
    jobs = max(1, min(jobs, count))
    for _ in range(jobs):
        waiting.put(None)
    runtimes = [WarmRuntime(prepared, site) for _ in range(jobs)]
    threads = [Thread(target=_work, args=(design, each, waiting, done), daemon=True) for each in runtimes]
    for thread in threads:
        thread.start()
    try:
        for _ in range(count):
            result = done.get()
            if isinstance(result, BaseException):
                raise result
            if result is not None:
                yield result
    except BaseException:
        for runtime in runtimes:
            runtime.end_at_once()
        raise
    finally:
        while not waiting.empty():
            waiting.get()
        for _ in threads:
            waiting.put(None)
        for thread in threads:
            thread.join()


def _work(
    design: SweepDesign,
    warm_runtime: WarmRuntime,
    waiting: "SimpleQueue[Case | None]",
    done: "SimpleQueue[CaseResult | BaseException | None]",
) -> None:
    """One thread: a runtime, and cases until there is none."""
    try:
        with warm_runtime as runtime:
            while (case := waiting.get()) is not None:
                done.put(runtime.do(case, design.settings_of(case), LONGEST_S))
    except BaseException as wrong:
        done.put(wrong)
