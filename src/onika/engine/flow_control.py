"""Flow control: decides what the user may do with a flow, and does it (requirements E07, E13, §5.9.2)."""

from collections.abc import Sequence

from msgspec.structs import replace

from onika.engine.flow import FlowState
from onika.engine.flow_router import FlowRouter
from onika.engine.orders import Off, Order, RunNote, Switch
from onika.engine.progress import Progress
from onika.engine.recovery import ErrorRecovery
from onika.wire.plan import Join
from onika.wire.steer import Leave, Mark, Pass, Pause, Recover, Resume, Skip, Steering, Step
from onika.words.reason import NOTHING, Reason

_UNDER_WAY = (
    FlowState.SPAWNING,
    FlowState.RUNNING,
    FlowState.WAITING,
    FlowState.JOINING,
    FlowState.PAUSED,
    FlowState.STOPPED,
    FlowState.CLEARING,
)
_SENT_FROM = (FlowState.RUNNING, FlowState.WAITING, FlowState.PAUSED, FlowState.STOPPED)


class FlowControl:
    """Refuses or carries out the steering messages for the flows of one plan."""

    def __init__(self, router: FlowRouter, recovery: ErrorRecovery) -> None:
        self._router = router
        self._recovery = recovery

    def refusal(self, flow: Progress, command: Steering) -> Reason:
        """Why this cannot be done now; empty: it can."""
        match command:
            case Mark():
                return _no_such_action(flow, command.action)
            case Recover():
                is_stopped = flow.state is FlowState.STOPPED
                if is_stopped:
                    return NOTHING
                return _expected(Reason.of("engine.stopped_at_error"), flow)
            case Pass():
                return self._why_not_pass(flow)
            case Skip():
                return self._why_not_skip(flow, command)
            case Resume():
                is_resting = flow.state is FlowState.PAUSED or (flow.is_pausing and flow.state in _UNDER_WAY)
                if is_resting:
                    return NOTHING
                return _expected(Reason.of("engine.paused"), flow)
            case Pause() | Step() | Leave():
                return self._why_not_under_way(flow, command)

    def steer(self, flow: Progress, command: Steering) -> list[Order]:
        """Do what `refusal` allows."""
        match command:
            case Pause():
                return self._pause(flow)
            case Step():
                return self._step(flow)
            case Resume():
                return self._resume(flow)
            case Skip():
                return self._skip(flow, command.action)
            case Pass():
                return self._pass(flow)
            case Leave():
                name = self._innermost(flow)
                flow.leaving |= {name}
                flow.revision += 1
                return [flow.moved(text=Reason.of("engine.leaves_loop", name=name))]
            case Mark():
                return _mark(flow, command)
            case Recover():
                return self._recovery.recover(flow)

    # Pausing

    def _pause(self, flow: Progress) -> list[Order]:
        if flow.state is FlowState.WAITING:
            return [*self._router.withdraw(flow), *self._router.rest(flow)]
        if flow.state is FlowState.JOINING:
            return self._router.rest(flow)
        return self._will_pause(flow)

    def _will_pause(self, flow: Progress) -> list[Order]:
        flow.is_pausing = True
        flow.revision += 1
        if flow.state is FlowState.SPAWNING:
            return [flow.moved(text=Reason.of("engine.pauses_first"))]
        return [flow.moved(text=Reason.of("engine.pauses_next"))]

    def _resume(self, flow: Progress) -> list[Order]:
        flow.is_pausing = False
        if flow.state is FlowState.PAUSED:
            return self._router.go_on([flow.flow])
        flow.revision += 1
        return [flow.moved(text=Reason.of("engine.does_not_pause"))]

    def _step(self, flow: Progress) -> list[Order]:
        if flow.state is not FlowState.PAUSED:
            return self._will_pause(flow)
        flow.is_pausing = True
        return self._router.go_on([flow.flow])

    def _why_not_under_way(self, flow: Progress, command: Pause | Step | Leave) -> Reason:
        if flow.state not in _UNDER_WAY:
            return _expected(Reason.of("engine.under_way"), flow)
        if isinstance(command, Leave):
            is_in_loop = bool(self._innermost(flow))
            if is_in_loop:
                return NOTHING
            return Reason.of("engine.not_in_loop", flow=flow.flow)
        is_paused = isinstance(command, Pause) and flow.state is FlowState.PAUSED
        if is_paused:
            return Reason.of("engine.paused_already", flow=flow.flow)
        return NOTHING

    # Elsewhere

    def _why_not_skip(self, flow: Progress, skip: Skip) -> Reason:
        was_done = flow.state is FlowState.STOPPED and flow.interrupted is FlowState.DONE
        if flow.state not in _SENT_FROM or was_done:
            return _expected(Reason.of("engine.at_an_action"), flow)
        if skip.action is None:
            is_waiting = flow.state is FlowState.WAITING
            if is_waiting:
                return Reason.of("engine.waits_at_tag", flow=flow.flow)
            return NOTHING
        return _no_such_action(flow, skip.action) or _out_of_reach(flow, skip.action)

    def _skip(self, flow: Progress, action: int | None) -> list[Order]:
        orders: list[Order] = []
        left: list[Off] = []
        step = flow.step
        if flow.state is FlowState.RUNNING and step is not None:
            orders = [RunNote(flow.flow, Reason.of("engine.left_by_user", place=step.place))]
            left = flow.flow_tasks.rest(step.triggers)
        elif flow.state is FlowState.WAITING:
            orders = self._router.withdraw(flow)
        orders += flow.leave_alone()
        flow.go(action)
        if flow.state is FlowState.STOPPED:
            return orders + self._recovery.recover_elsewhere(flow)
        return orders + _left_at_once(left, self._router.go_on([flow.flow]))

    def _why_not_pass(self, flow: Progress) -> Reason:
        if flow.state is FlowState.JOINING and not isinstance(flow.next, Join):
            return Reason.of("engine.waits_to_begin_again", flow=flow.flow)
        is_waiting = flow.state in (FlowState.WAITING, FlowState.JOINING)
        if is_waiting:
            return NOTHING
        return _expected(Reason.of("engine.waiting_for_flow"), flow)

    def _pass(self, flow: Progress) -> list[Order]:
        passed = self._router.let_pass(flow) if flow.state is FlowState.WAITING else []
        flow.advance()
        return passed + self._router.go_on([flow.flow])

    def _innermost(self, flow: Progress) -> str:
        """The innermost loop around the flow's place that it is not leaving already; empty: none."""
        names = [loop.name for loop in flow.program.loops_at(flow.place) if loop.name not in flow.leaving]
        return names[-1] if names else ""


def _left_at_once(left: Sequence[Off], onward: Sequence[Order]) -> list[Order]:
    """What goes off goes in the switch with which its flow goes on, if any: that may need its variables."""
    tasks = tuple(off.task for off in left)
    of_flow = (order for order in onward if isinstance(order, Switch) and left and order.flow == left[0].flow)
    switch = next(of_flow, None)
    if switch is None:
        return [*left, *onward]
    whole = replace(switch, off=(*tasks, *switch.off))
    return [whole if order is switch else order for order in onward]


def _mark(flow: Progress, mark: Mark) -> list[Order]:
    if mark.is_set:
        flow.breakpoints[mark.action] = mark.condition
    else:
        flow.breakpoints.pop(mark.action, None)
    flow.revision += 1
    return []


def _no_such_action(flow: Progress, action: int) -> Reason:
    count = len(flow.program.is_noop)
    if 0 <= action < count:
        return NOTHING
    return Reason.of("engine.no_such_action", count=count, flow=flow.flow, number=action + 1)


def _out_of_reach(flow: Progress, action: int) -> Reason:
    """Why a flow cannot be sent from where it is to an action that it has; empty: it can."""
    program, to = flow.program, flow.program.entries[action]
    if program.stretch(flow.place) != program.stretch(to):
        return Reason.of("engine.of_another_run", action=action, flow=flow.flow)
    if program.parallel_at(flow.place) != program.parallel_at(to):
        return Reason.of("engine.on_another_side", action=action, flow=flow.flow)
    return NOTHING


def _expected(what: Reason, flow: Progress) -> Reason:
    return Reason.of("engine.other_state", flow=flow.flow, what=what, state=flow.state.value)
