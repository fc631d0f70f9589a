"""A sweep on the workers of a cluster, by Dask: only bytes cross, and a worker that dies loses nothing (X23)."""

import logging
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any

import msgspec

from onika.desk.sweep import swept_program
from onika.desk.sweep.case import Case, CaseResult
from onika.desk.sweep.cluster_work import carry_out, decode_answer, own_build
from onika.desk.sweep.swept_program import SweptProgram
from onika.words.reason import Reason

_PATIENCE_S = 10.0
_AHEAD = 4
"""Cases that lie at the cluster for each of its threads."""


class NoCluster(OSError):
    """There is no such cluster, or it cannot do this sweep; its only argument says why, a `Reason`."""


def cluster_sweep(program: SweptProgram, cases: Iterable[Case], address: str, jobs: int) -> Iterator[CaseResult]:
    """Do these cases on the cluster whose scheduler is there; each result as soon as it is there, in any order.

    address   `tcp://HOST:PORT`, or `tls://` with the certificates that Dask is configured with
    jobs      how many cases lie at the cluster at a time; 0: as many as its threads want

    Raises NoCluster. Whoever stops listening ends it: what is under way then is lost.
    """
    try:
        from distributed import as_completed
    except ImportError:
        raise NoCluster(Reason.of("sweep.no_dask")) from None
    client = _client(address)
    try:
        threads = sum(client.nthreads().values())
        # a result of a task, not scattered data: should its only worker die, the scheduler makes it anew
        shared = client.submit(bytes, swept_program.encode(program), key=f"onika-{own_build()}-{id(client)}")
        waiting = iter(cases)
        futures = {_submit(client, shared, case): case for case in islice(waiting, jobs or _AHEAD * max(1, threads))}
        done = as_completed(list(futures), loop=client.loop)
        for future in done:
            yield _result(future, futures.pop(future))
            for case in islice(waiting, 1):
                added = _submit(client, shared, case)
                futures[added] = case
                done.add(added)
    finally:
        client.close(timeout=_PATIENCE_S)


def _client(address: str) -> Any:
    from distributed import Client

    for name in ("distributed", "distributed.client"):
        logging.getLogger(name).setLevel(logging.CRITICAL)  # what is wrong is told in our words
    try:
        return Client(address, timeout=_PATIENCE_S, set_as_default=False)
    except (OSError, TimeoutError, ValueError, ImportError) as wrong:
        raise NoCluster(Reason.of("sweep.no_cluster", address=address, why=Reason.plain(str(wrong)))) from None


def _submit(client: Any, program: Any, case: Case) -> Any:
    return client.submit(carry_out, program, msgspec.msgpack.encode(case), own_build(), pure=False)


def _result(future: Any, case: Case) -> CaseResult:
    """What came of a case; one whose workers died each time is lost."""
    from distributed import KilledWorker

    if future.status == "cancelled":
        raise NoCluster(Reason.of("sweep.cluster_gone"))
    try:
        answer = decode_answer(future.result())
    except KilledWorker:
        return CaseResult(case, "lost", Reason.of("sweep.workers_died"))
    if answer.result is None:
        raise NoCluster(Reason.of("sweep.other_build", worker=answer.worker, here=own_build(), there=answer.build))
    return answer.result
