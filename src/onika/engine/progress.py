"""The progress of one flow of an application: its state, its place in its program, what its user wants (§5.9.2)."""

from collections.abc import Callable, Mapping

from onika.engine.flow import FlowEvent, FlowState, after
from onika.engine.flow_tasks import FlowTasks
from onika.engine.lookahead import ways
from onika.engine.orders import Began, Case, Disperse, Done, Moved, Order, RunNote, Switch
from onika.engine.program import FlowProgram
from onika.engine.step import ActionStep
from onika.engine.walk import FinishValue, WalkResult, walk
from onika.wire.plan import Do, Instruction, Meet, PlannedFlow
from onika.words.reason import NOTHING, Reason


class Progress:
    """One flow under execution. `judge` says whether a condition on variables holds now."""

    def __init__(
        self,
        flow: int,
        planned: PlannedFlow,
        program: FlowProgram,
        steps: tuple[ActionStep, ...],
        ranks: Mapping[str, int],
        judge: Callable[[str], bool],
    ) -> None:
        self.flow = flow
        self.parent = planned.parent
        self.program = program
        self.flow_tasks = FlowTasks(flow, planned, ranks)
        self.state = FlowState.READY
        self.current = -1
        """The action that runs, or ran last; a no-op too."""
        self.step: ActionStep | None = None
        """The same, but never a no-op: what is ON belongs to it."""
        self.is_pausing = False
        """Whether it rests after its current action."""
        self.leaving: frozenset[str] = frozenset()
        """The loops that are left at their next test."""
        self.breakpoints = dict(program.breakpoints)
        self.interrupted = FlowState.RUNNING
        """What it did when a task failed."""
        self.open_tag = ""
        """The tag at which it has begun, and perhaps alone: flows of other runtimes have not said that they have."""
        self.met_at = -1
        """The place of that tag in its program."""
        self.alone_at = -1
        """The place of the tag at which it has begun alone, and is held; -1: it has not."""
        self.revision = 0
        """Counts whatever may change what comes next."""
        self._judge = judge
        self._steps = steps
        self._pc = 0 if planned.parent is None else program.end
        self._value: FinishValue | None = None

    @property
    def next(self) -> Instruction:
        """What comes next."""
        return self.program.instructions[self._pc]

    @property
    def place(self) -> int:
        """The place in the program where it is: that of the action while one runs."""
        if self.state is FlowState.RUNNING and self._pc:
            return self._pc - 1
        return self._pc

    def where(self, task: str) -> Reason:
        """A task and where the run stands, for messages."""
        place = self._steps[self.current].place if self.current >= 0 else self.flow_tasks.place(task)
        return Reason.of("engine.name_at", place=place, name=task)

    def enter(self, event: FlowEvent) -> None:
        """Into the state that an event leads to."""
        self.state = after(self.state, event)
        self.revision += 1

    def moved(self, tag: str = "", waits_for: tuple[int, ...] = (), text: Reason = NOTHING) -> Moved:
        """For the watcher: where the flow is now."""
        return Moved(self.flow, self.state.value, self.current, tag, waits_for, text)

    # On its way

    def advance(self) -> None:
        """The next instruction is done with."""
        self._pc += 1

    def go(self, action: int | None) -> None:
        """To another action, or on from here, without any value of an action before (readings 21 and 22)."""
        self.go_to(self._pc if action is None else self.program.entries[action])

    def go_to(self, place: int) -> None:
        """To another place of the program."""
        self._pc = place
        self._value = None
        around = {loop.name for loop in self.program.loops_at(place)}
        self.leaving &= around

    def begins_at(self, tag: str) -> None:
        """It goes on behind a tag at which other runtimes meet."""
        self.open_tag = tag
        self.met_at = self._pc
        self.advance()

    def go_back(self) -> str:
        """To the tag at which it has begun alone, which is returned."""
        self._pc, self.alone_at = self.alone_at, -1
        self.revision += 1
        instruction = self.next
        if not isinstance(instruction, Meet):
            raise ValueError(Reason.of("engine.form_begin", instruction=str(instruction)))
        return instruction.tag

    def leave_alone(self) -> list[Order]:
        """It goes elsewhere than to the tag at which it has begun alone, if it has."""
        if self.alone_at < 0:
            return []
        return [Disperse(self.go_back(), was_there=True)]

    def ends_with(self, value: FinishValue) -> Done:
        """The current action has ended, and with what."""
        self._value = value
        self.revision += 1
        return Done(self.flow, self.current)

    def walk(self) -> tuple[WalkResult, list[Order]]:
        """To the next instruction that takes time or needs others; what is to be told of the way."""
        way = walk(self.program, self._pc, self._value, self.leaving, self._judge, self.rests_after)
        self._pc, self._value, self.leaving = way.pc, way.value, way.left
        orders: list[Order] = [RunNote(self.flow, self._behind_step(note)) for note in way.notes]
        for action in way.passed:
            self.current = action
            orders += [Began(self.flow, action), Done(self.flow, action)]
        return way, orders

    def _behind_step(self, note: Reason) -> Reason:
        """A note of the way, with the step that it leads away from."""
        if self.step is None:
            return note
        return Reason.of("engine.note_at", place=self.step.place, note=note)

    def rests_after(self, action: int) -> bool:
        """Whether the flow pauses after this action: the user wants it, or there is a breakpoint."""
        if self.is_pausing:
            return True
        condition = self.breakpoints.get(action)
        return condition is not None and (not condition or self._judge(condition))

    def begin(self, number: int = 0) -> list[Order]:
        """The next instruction is a Do: switch to its action. `number` is that of the case that did so already."""
        instruction = self.next
        if not isinstance(instruction, Do):
            raise ValueError(Reason.of("engine.form_begin", instruction=str(instruction)))
        self.current = instruction.action
        self._pc += 1
        return self.repeat(number)

    def repeat(self, number: int = 0) -> list[Order]:
        """Switch to the current action."""
        was = self.state
        step = self.step = self._steps[self.current]
        self.enter(FlowEvent.BEGIN)
        switch = self.flow_tasks.change(step, number)
        self.flow_tasks.carry_out(step, switch)
        self.flow_tasks.failed.clear()
        orders: list[Order] = [switch, Began(self.flow, self.current)]
        if was not in (FlowState.RUNNING, FlowState.SPAWNING):
            orders.append(self.moved())
        if not step.triggers:
            where = Reason.of("engine.name_at", place=step.place, name=step.name)
            orders.append(RunNote(self.flow, Reason.of("engine.no_trigger", where=where)))
        return orders

    def finished(self, task: str) -> bool:
        """A task ended its job; False if that does not end the action.

        It must be a trigger of the action and have been ON in it: the second word of a trigger that has
        finished, or one that was long under way, would else end the next action as well.
        """
        was_on = self.flow_tasks.switched_off(task)
        step = self.step
        return was_on and self.state is FlowState.RUNNING and step is not None and task in step.triggers

    # What may come

    def switch_behind(self) -> Switch | None:
        """The switch with which it goes on behind the tag where it waits; None where that is not clear yet."""
        if self.is_pausing or not self.flow_tasks.is_settled:
            return None
        foreseen = list(ways(self.program, self._pc + 1, self.leaving))
        if len(foreseen) != 1 or foreseen[0][2].passed:
            return None
        instruction = self.program.instructions[foreseen[0][2].pc]
        return self.flow_tasks.change(self._steps[instruction.action]) if isinstance(instruction, Do) else None

    def cases(self) -> list[Case]:
        """The switch for each way the current action may end; none where it is not known yet what follows it."""
        step = self.step
        if step is None or self.state is not FlowState.RUNNING or len(step.triggers) != 1:
            return []
        is_open = self.is_pausing or bool(self.open_tag)
        if is_open or self.current in self.breakpoints or not self.flow_tasks.is_settled:
            return []
        cases = []
        for choice, loop, way in ways(self.program, self._pc, self.leaving):
            instruction = self.program.instructions[way.pc]
            rests = any(action in self.breakpoints for action in way.passed)
            if isinstance(instruction, Do) and not rests:
                switch = self.flow_tasks.change(self._steps[instruction.action], finished=step.triggers[0])
                cases.append(Case(step.triggers[0], choice, loop, switch))
        return cases
