"""Tags that flows of this runtime share with flows of others: who may go on there is agreed elsewhere (decision 56).

When all flows of this runtime that meet at the tag are there, they are convened. They begin when that is agreed; but
no action that has begun so is ended before all others are known to have begun theirs. Who has begun alone stops; where
nothing of it can have moved anything, all meet again at once.
"""

from collections.abc import Callable

from onika.engine.flow import FlowState
from onika.engine.flow_router import FlowRouter
from onika.engine.news import Agreed, BegunAlone, Closed, Finished
from onika.engine.orders import Convene, Order
from onika.engine.progress import Progress
from onika.engine.recovery import ErrorRecovery
from onika.words.reason import Reason


class SharedTags:
    """Serves all flows of one engine. `finish` carries out what a trigger has said, `abort` ends the application."""

    def __init__(
        self,
        flows: list[Progress],
        router: FlowRouter,
        recovery: ErrorRecovery,
        finish: Callable[[Progress, Finished], list[Order]],
        abort: Callable[[Reason], list[Order]],
    ) -> None:
        self._flows = flows
        self._router = router
        self._recovery = recovery
        self._finish = finish
        self._abort = abort
        self._finished: dict[int, Finished] = {}

    def hear(self, news: Agreed | Closed | BegunAlone) -> list[Order]:
        """What follows from what was agreed with other runtimes."""
        match news:
            case Agreed():
                return self._router.agreed(news.tag, news.switched)
            case Closed():
                return self._close(news.tag)
            case BegunAlone():
                return self._alone(news)

    def keeps(self, flow: Progress, news: Finished) -> bool:
        """Whether the end of the action has to wait until all others have begun."""
        if not flow.open_tag:
            return False
        self._finished[flow.flow] = news
        return True

    def _close(self, tag: str) -> list[Order]:
        orders: list[Order] = []
        for flow in self._of(tag):
            flow.open_tag = ""
            flow.revision += 1
            finished = self._finished.pop(flow.flow, None)
            if finished is not None:
                orders += self._finish(flow, finished)
        return orders

    def _alone(self, news: BegunAlone) -> list[Order]:
        orders: list[Order] = []
        for flow in self._of(news.tag):
            flow.open_tag = ""
            self._finished.pop(flow.flow, None)
            if flow.state in (FlowState.KILLING, FlowState.ENDED):
                continue
            flow.alone_at = flow.met_at
            if flow.state is FlowState.RUNNING and not news.drives:
                orders += self._recovery.meet_again(flow, news.cause)
            elif self._recovery.stands_still:
                orders += self._recovery.alone(flow, news.cause)
            else:
                return orders + self._abort(news.cause)
        return _convened_once(orders)

    def _of(self, tag: str) -> list[Progress]:
        return [flow for flow in self._flows if flow.open_tag == tag]


def _convened_once(orders: list[Order]) -> list[Order]:
    """Flows that come back together are convened when the last of them is there."""
    last = [order for order in orders if isinstance(order, Convene)][-1:]
    return [*(order for order in orders if not isinstance(order, Convene)), *last]
