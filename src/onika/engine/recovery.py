"""Recovery from errors in a flow: it stops, its failed tasks are cleared, the step is repeated (E08, §5.9.2)."""

from onika.engine.flow import FlowEvent, FlowState
from onika.engine.flow_router import FlowRouter
from onika.engine.orders import Clear, Order, RunNote
from onika.engine.progress import Progress
from onika.words.reason import Reason


class ErrorRecovery:
    """Stops flows and brings them back. `stands_still`: whether anybody is there to decide."""

    def __init__(self, router: FlowRouter, stands_still: bool) -> None:
        self._router = router
        self.stands_still = stands_still
        self._elsewhere: set[int] = set()

    def failed(self, flow: Progress, task: str, cause: Reason) -> list[Order]:
        """A task is in ERROR; its trigger goes off at once, lest the job go on without it."""
        flow.flow_tasks.has_failed(task)
        return self._stop(flow, cause)

    def refused(self, flow: Progress, task: str, cause: Reason) -> list[Order]:
        """A task would not come on; there is nothing to clear, but the step can be repeated."""
        flow.flow_tasks.would_not(task)
        return self._stop(flow, cause)

    def _stop(self, flow: Progress, cause: Reason) -> list[Order]:
        orders: list[Order] = []
        if flow.state not in (FlowState.STOPPED, FlowState.CLEARING):
            flow.interrupted = flow.state
            if flow.state is FlowState.WAITING:
                orders += self._router.withdraw(flow)
        if flow.step is not None and flow.interrupted is FlowState.RUNNING:
            orders += flow.flow_tasks.rest(flow.step.triggers)
        flow.enter(FlowEvent.FAIL)
        return [*orders, flow.moved(text=cause)]

    def alone(self, flow: Progress, cause: Reason) -> list[Order]:
        """The flow has begun alone: it waits for its user, where it has not stopped at an error of it already."""
        return self._stop(flow, cause)

    def meet_again(self, flow: Progress, cause: Reason) -> list[Order]:
        """The flow has begun alone, and has moved nothing: it waits at the tag once more, as if nothing had been."""
        triggers = flow.step.triggers if flow.step is not None else ()
        off = flow.flow_tasks.rest(triggers)
        return [RunNote(flow.flow, cause), *off, *self._router.come_back(flow, flow.go_back())]

    def recover(self, flow: Progress) -> list[Order]:
        """The user wants it: clear what is in ERROR, then repeat the step."""
        flow.enter(FlowEvent.RECOVER)
        clear = [Clear(flow.flow, task) for task in sorted(flow.flow_tasks.in_error)]
        return [flow.moved(), *clear, *self._when_cleared(flow)]

    def recover_elsewhere(self, flow: Progress) -> list[Order]:
        """As `recover`, but the flow then goes on from where it has been sent."""
        self._elsewhere.add(flow.flow)
        return self.recover(flow)

    def cleared(self, flow: Progress, task: str) -> list[Order]:
        """A task is OFF again."""
        flow.flow_tasks.in_error.discard(task)
        if flow.state is FlowState.CLEARING:
            return self._when_cleared(flow)
        return []

    def not_cleared(self, flow: Progress, cause: Reason) -> list[Order]:
        """A task would not be cleared: the flow stands still as before."""
        return self._stop(flow, cause)

    def _when_cleared(self, flow: Progress) -> list[Order]:
        if flow.flow_tasks.in_error:
            return []
        if flow.flow in self._elsewhere:
            self._elsewhere.discard(flow.flow)
            flow.flow_tasks.failed.clear()
            return self._router.go_on([flow.flow])
        if flow.alone_at >= 0:
            back = flow.flow_tasks.bring_back(flow.step)
            return back + self._router.come_back(flow, flow.go_back())
        if flow.interrupted is FlowState.RUNNING:
            return flow.repeat()
        back = flow.flow_tasks.bring_back(flow.step)
        if flow.interrupted is FlowState.PAUSED or flow.is_pausing:
            return back + self._router.rest(flow)
        return back + self._router.go_on([flow.flow])
