"""A runtime that does one run after the other: renewed between them, launched anew only where it died (X23)."""

from types import TracebackType

from onika.desk.plan.compile import rtpus_of
from onika.desk.plan.preparation import PreparedRun
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.run import NotRun, start_on
from onika.desk.run.settings import RunSettings
from onika.desk.sweep.case import Case, CaseResult
from onika.desk.trial.account import timed_events
from onika.link.lost import LinkLost
from onika.store.site import Site
from onika.wire import event, live, request
from onika.wire.plan import Plan
from onika.wire.world_values import WorldValues
from onika.words.reason import NOTHING, Reason, reason_of

_TRIES = 2


class WarmRuntime:
    """Does the cases of one sweep, one at a time; use as a `with` block, or close it."""

    def __init__(self, prepared: PreparedRun, site: Site) -> None:
        self._prepared = prepared
        self._site = site
        self._runtime: LaunchedRuntime | None = None
        self._is_over = False

    def __enter__(self) -> "WarmRuntime":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def do(self, case: Case, settings: RunSettings, limit_s: float) -> CaseResult:
        """Do a run; one whose runtime dies is done once more, on a new one."""
        for tried in range(1, _TRIES + 1):
            try:
                return self._run(case, settings, limit_s)
            except (LinkLost, TimeoutError) as lost:
                self.close()
                if tried == _TRIES or self._is_over:
                    return CaseResult(case, "lost", reason_of(lost))
        raise AssertionError("unreachable")

    def end_at_once(self) -> None:
        """From any thread: what is under way is lost, and nothing is done any more."""
        self._is_over = True
        runtime = self._runtime
        if runtime is not None:
            runtime.end_at_once()

    def _run(self, case: Case, settings: RunSettings, limit_s: float) -> CaseResult:
        def runtime_for(plan: Plan, values: WorldValues) -> LaunchedRuntime:
            return self._ready(plan, settings.shake, values)

        try:
            with start_on(runtime_for, settings, self._site, self._prepared) as running:
                for _ in timed_events(running, limit_s):
                    pass
                result = running.result()
                running.close()
        except NotRun as refused:
            return CaseResult(case, "refused", refused.faults[0].reason if refused.faults else NOTHING)
        unmet = tuple(condition.text for condition, _, holds in running.outcome.expectations if not holds)
        return _result(case, result, unmet)

    def _ready(self, plan: Plan, shake: int | None, values: WorldValues) -> LaunchedRuntime:
        """A runtime on which nothing has happened yet."""
        if self._runtime is None:
            launched = LaunchedRuntime(rtpus_of(plan), True, False, (), has_black_box=False)
            self._runtime = launched.__enter__()
        if self._is_over:  # since it was asked for
            raise TimeoutError(Reason.of("trial.no_end"))
        answer = self._runtime.ask(live.Renew(shake, values))
        if not isinstance(answer, request.Done):
            raise TimeoutError(answer.reason if isinstance(answer, request.Refused) else NOTHING)
        for _ in self._runtime.events(0.0):  # what was told of the run before
            pass
        return self._runtime

    def close(self) -> None:
        """End the runtime that is there."""
        runtime, self._runtime = self._runtime, None
        if runtime is not None:
            runtime.__exit__(None, None, None)


def _result(case: Case, result: event.Result, unmet: tuple[str, ...]) -> CaseResult:
    cause = NOTHING if result.completed else result.cause or Reason.of("trial.no_end")
    return CaseResult(case, "completed" if result.completed else "aborted", cause, unmet, result.runtime_s, result.hash)
