"""The router of all flows: who goes on, who waits for whom, who begins together (§5.5.4, reading 26, X03)."""

from collections import deque
from collections.abc import Callable, Collection, Iterable, Sequence

from onika.engine.flow import FlowEvent, FlowState
from onika.engine.meeting import Meetings
from onika.engine.orders import Convene, Disperse, Moved, Order, Settle, Switch, Together
from onika.engine.progress import Progress
from onika.wire.plan import Do, Fork, Halt, Join, Meet, Rest
from onika.wire.steer import Position
from onika.words.reason import NOTHING, Reason

_MOST_STEPS = 100_000
"""Steps without time at one instant; flows that make more go round together for ever."""


class FlowRouter:
    """Moves flows on, as far as they go without anything having to happen. `names` are their subsystems."""

    def __init__(self, flows: Sequence[Progress], names: Sequence[str], shared: Collection[str] = ()) -> None:
        self._flows = flows
        self._names = names
        self.meetings = Meetings([flow.program for flow in flows], shared)
        self.astray = NOTHING
        """Why the application cannot go on; empty: it can."""
        self._going: deque[int] = deque()
        """The flows that are still to be moved on; none of them has ended, whatever its state says."""
        self._met = ""
        """The tag at which flows have met last."""

    # Going on

    def go_on(self, flows: Iterable[int], number: int = 0, tag: str = "") -> list[Order]:
        """These flows go on from where they are; `number` is that of the case that was carried out already.

        `tag` is that at which they have met already.
        """
        orders: list[Order] = []
        begun: list[Order] = []
        self._met = tag
        self._going = deque(flows)
        for _ in range(_MOST_STEPS):
            if not self._going:
                break
            flow = self._flows[self._going.popleft()]
            way, on_the_way = flow.walk()
            orders += on_the_way
            instruction = flow.next
            if way.is_endless:
                self.astray = Reason.of("engine.goes_round", flow=flow.flow)
                return orders
            if way.rests:
                orders += self.rest(flow)
            elif isinstance(instruction, Do):
                begun += flow.begin(number)
            elif isinstance(instruction, Meet):
                orders += self._meet(flow, instruction.tag)
            else:
                orders += self._pass_by(flow)
        else:
            self.astray = Reason.of("engine.meet_for_ever")
            return orders
        together = tuple(order.flow for order in begun if isinstance(order, Switch))
        return orders + ([Together(self._met, together)] if len(together) > 1 else []) + begun + self._settle()

    def _meet(self, flow: Progress, tag: str) -> list[Order]:
        if tag in self.meetings.shared:
            self.meetings.arrive(flow.flow, tag)
            return self._wait_for_others(flow, tag)
        together = self.meetings.arrive(flow.flow, tag)
        for number in together:
            self._flows[number].advance()
        self._going += together
        if flow.flow in together:
            self._met = tag
            return []
        flow.enter(FlowEvent.HOLD)
        return [self.waits(flow)]

    # With other runtimes

    def agreed(self, tag: str, number: int) -> list[Order]:
        """The flows that wait at a tag for those of other runtimes begin; `number` is that of what has switched.

        What was agreed may be told when the application is being ended already: then nothing goes on.
        """
        waiting = self.meetings.release(tag)
        together = [flow for flow in waiting if self._flows[flow].state not in (FlowState.KILLING, FlowState.ENDED)]
        for flow in together:
            self._flows[flow].begins_at(tag)
        return self.go_on(together, number, tag)

    def come_back(self, flow: Progress, tag: str) -> list[Order]:
        """A flow that has begun alone waits at the tag once more."""
        self.meetings.come_back(flow.flow, tag)
        return self._wait_for_others(flow, tag, anew=True)

    def withdraw(self, flow: Progress) -> list[Order]:
        """A flow does not wait at its tag at present."""
        return self._disperse(flow, self.meetings.withdraw)

    def let_pass(self, flow: Progress) -> list[Order]:
        """A flow does not wait at its tag any longer, and has been there."""
        return self._disperse(flow, self.meetings.let_pass)

    def _wait_for_others(self, flow: Progress, tag: str, anew: bool = False) -> list[Order]:
        flow.enter(FlowEvent.HOLD)
        together = self.meetings.gathered(tag)
        if not together:
            return [self.waits(flow)]
        ahead = [self._flows[number].switch_behind() for number in together]
        switches = tuple(switch for switch in ahead if switch is not None)
        whole = switches if len(switches) == len(together) else ()
        return [self.waits(flow), Convene(tag, tuple(together), whole, anew)]

    def _disperse(self, flow: Progress, give_up: Callable[[int], None]) -> list[Order]:
        tag = self.meetings.waits_at(flow.flow)
        was_gathered = tag in self.meetings.shared and flow.flow in self.meetings.gathered(tag)
        was_there = give_up == self.meetings.let_pass
        give_up(flow.flow)
        left = self.meetings.gathered(tag)
        if not was_gathered or (was_there and left):
            return []
        return [Disperse(tag, was_there)]

    def _pass_by(self, flow: Progress) -> list[Order]:
        instruction = flow.next
        match instruction:
            case Rest():
                flow.advance()
                return self.rest(flow)
            case Fork():
                if self._not_done(number for number, _ in instruction.flows):
                    return self._join(flow)
                flow.advance()
                self._going.append(flow.flow)
                return [
                    order for number, place in instruction.flows for order in self._fork(self._flows[number], place)
                ]
            case Join():
                if self._not_done(instruction.flows):
                    return self._join(flow)
                flow.advance()
                self._going.append(flow.flow)
            case Halt():
                return self._complete(flow)
        return []

    def _fork(self, child: Progress, place: int) -> list[Order]:
        self.meetings.begin_anew(child.program.tags_from(place))
        child.go_to(place)
        if child.is_pausing:
            return self.rest(child)
        self._going.append(child.flow)
        return []

    def _join(self, flow: Progress) -> list[Order]:
        flow.enter(FlowEvent.JOIN)
        return [self.waits(flow)]

    def _complete(self, flow: Progress) -> list[Order]:
        flow.enter(FlowEvent.COMPLETE)
        flow.is_pausing = False
        parent = None if flow.parent is None else self._flows[flow.parent]
        if parent is not None and parent.state is FlowState.JOINING and parent.flow not in self._going:
            self._going.append(parent.flow)
        waiting = (waiting_flow for waiting_flow in self._flows if self.meetings.waits_at(waiting_flow.flow))
        return [
            flow.moved(),
            *(self.waits(waiting_flow) for waiting_flow in waiting if flow.flow in self.waits_for(waiting_flow)),
        ]

    def _not_done(self, flows: Iterable[int]) -> list[int]:
        return [flow for flow in flows if self._flows[flow].state is not FlowState.DONE or flow in self._going]

    def _settle(self) -> list[Order]:
        if all(flow.state is FlowState.DONE for flow in self._flows):
            return [Settle()]
        return []

    def rest(self, flow: Progress) -> list[Order]:
        """Pause here."""
        flow.is_pausing = False
        flow.enter(FlowEvent.REST)
        return [flow.moved()]

    # Waiting

    def waits(self, flow: Progress) -> Moved:
        """For the watcher: where a flow waits, and for whom."""
        absent = self.waits_for(flow)
        ended = [number for number in absent if self._has_ended(number)]
        text = NOTHING
        if ended and flow.state is FlowState.WAITING:
            text = Reason.of("engine.will_not_come", flows=tuple(ended))
        elif not absent and flow.state is FlowState.WAITING:
            text = Reason.of("engine.waits_for_other_runtimes")
        return flow.moved(self.meetings.waits_at(flow.flow), tuple(absent), text)

    def waits_for(self, flow: Progress) -> list[int]:
        """The flows a flow waits for."""
        if flow.state is FlowState.WAITING:
            return self.meetings.absent(flow.flow)
        instruction = flow.next if flow.state is FlowState.JOINING else None
        if isinstance(instruction, Join):
            return self._not_done(instruction.flows)
        if isinstance(instruction, Fork):
            return self._not_done(number for number, _ in instruction.flows)
        return []

    def _has_ended(self, number: int) -> bool:
        """Whether a flow is done for good; one that is begun by another may be begun again."""
        flow = self._flows[number]
        return flow.state is FlowState.DONE and (flow.parent is None or self._has_ended(flow.parent))

    def position(self, flow: Progress) -> Position:
        """Where a flow is."""
        is_waiting = flow.state is FlowState.WAITING
        return Position(
            subsystem=self._names[flow.flow],
            state=flow.state.value,
            action=flow.current,
            tag=self.meetings.waits_at(flow.flow) if is_waiting else "",
            waits_for=tuple(self._names[number] for number in self.waits_for(flow)),
            is_pausing=flow.is_pausing,
            loops=tuple(loop.name for loop in flow.program.loops_at(flow.place)),
            failed=tuple(flow.flow_tasks.failed),
            breakpoints=tuple(sorted(flow.breakpoints)),
        )
