"""The walk of a flow from one action to the next: what tests, branches and no-ops on the way decide (Table 9).

It changes nothing. `WalkResult.pc` is the next instruction that takes time or needs others: a Do of a job, Meet, Fork,
Join, Rest or Halt; or the one behind a no-op after which the flow is to rest.
"""

from collections.abc import Callable

from msgspec import Struct

from onika.engine.program import FlowProgram
from onika.wire.plan import Again, Choose, Do, Jump, Rest, Unless
from onika.words.reason import NOTHING, Reason

Judge = Callable[[str], bool]
"""Whether a condition on variables holds now."""


class FinishValue(Struct, frozen=True):
    """What the last action returned."""

    choice: int = 0
    loop: bool = False


NOOP = FinishValue(0, loop=True)
"""What a no-op returns (requirement D11)."""


class WalkResult(Struct, frozen=True):
    """Where a walk leads."""

    pc: int
    value: FinishValue | None
    left: frozenset[str]
    """The loops that were to be left and have not been."""
    passed: tuple[int, ...] = ()
    """The no-ops on the way."""
    notes: tuple[Reason, ...] = ()
    rests: bool = False
    """Whether the flow is to rest here, behind a no-op."""
    is_endless: bool = False
    """Whether it goes round for ever without taking any time."""


def walk(
    program: FlowProgram,
    pc: int,
    value: FinishValue | None,
    leaving: frozenset[str],
    judge: Judge,
    rests_after: Callable[[int], bool],
) -> WalkResult:
    """From instruction `pc` on; without a value every loop is left and flow 0 is taken (readings 21 and 22).

    leaving      the loops that are to be left at their next test
    rests_after  whether the flow rests after this no-op
    """
    instruction = program.instructions[pc]
    if isinstance(instruction, Do) and not program.is_noop[instruction.action]:
        return WalkResult(pc, value, leaving)  # as nearly always
    walker = _Walker(program, pc, value, leaving, judge, rests_after)
    passed_states: set[tuple[int, FinishValue | None, frozenset[str]]] = set()
    while walker.state not in passed_states:
        passed_states.add(walker.state)
        if not walker.step():
            return walker.result()
    return walker.result(is_endless=True)


class _Walker:
    """Goes through a program, one instruction at a time."""

    def __init__(
        self,
        program: FlowProgram,
        pc: int,
        value: FinishValue | None,
        leaving: frozenset[str],
        judge: Judge,
        rests_after: Callable[[int], bool],
    ) -> None:
        self._program = program
        self._pc = pc
        self._value = value
        self._leaving = leaving
        self._judge = judge
        self._rests_after = rests_after
        self._passed: list[int] = []
        self._notes: list[Reason] = []
        self._rests = False

    @property
    def state(self) -> tuple[int, FinishValue | None, frozenset[str]]:
        """What decides the way from here on."""
        return self._pc, self._value, self._leaving

    def result(self, *, is_endless: bool = False) -> WalkResult:
        """Where it has led."""
        passed, notes = tuple(self._passed), tuple(self._notes)
        return WalkResult(self._pc, self._value, self._leaving, passed, notes, self._rests, is_endless)

    def step(self) -> bool:
        """Past an instruction; False where the walk ends, before one that takes time or behind a no-op."""
        instruction = self._program.instructions[self._pc]
        match instruction:
            case Do() if self._program.is_noop[instruction.action]:
                self._pass_noop(instruction.action)
                return not self._rests
            case Rest() if self._passes(instruction):
                self._pc += 1
            case Choose():
                self._choose(instruction)
            case Again() | Unless():
                self._test(instruction)
            case Jump():
                self._jump(instruction)
            case _:
                return False
        return True

    def _pass_noop(self, action: int) -> None:
        self._passed.append(action)
        self._value = NOOP
        self._pc += 1
        self._rests = self._rests_after(action)

    def _passes(self, rest: Rest) -> bool:
        """Whether a breakpoint holds nobody up: it belongs to an action, or its condition does not hold."""
        if rest.action >= 0:
            return True
        return bool(rest.condition) and not self._judge(rest.condition)

    def _choose(self, choose: Choose) -> None:
        choice, note = _choice(choose, self._value, self._judge)
        if note:
            self._notes.append(note)
        self._pc = choose.to[choice]

    def _test(self, test: Again | Unless) -> None:
        goes_on = test.loop not in self._leaving and _goes_on(test, self._value, self._judge)
        if not goes_on:
            self._leaving -= {test.loop}
        jumps = goes_on == isinstance(test, Again)
        self._pc = test.to if jumps else self._pc + 1

    def _jump(self, jump: Jump) -> None:
        if jump.loop in self._leaving:
            self._leaving -= {jump.loop}
            self._pc += 1
        else:
            self._pc = jump.to


def _goes_on(instruction: Again | Unless, value: FinishValue | None, judge: Judge) -> bool:
    if instruction.condition:
        return judge(instruction.condition)
    return value is not None and value.loop


def _choice(choose: Choose, value: FinishValue | None, judge: Judge) -> tuple[int, Reason]:
    """Which way, and what is worth saying of it (reading 20)."""
    last = len(choose.to) - 1
    if choose.conditions:
        return next((at for at, condition in enumerate(choose.conditions) if judge(condition)), last), NOTHING
    if value is None or not last:
        return 0, NOTHING
    if value.choice <= last:
        return value.choice, NOTHING
    name = choose.name or Reason.of("engine.the_branch")
    return 0, Reason.of("engine.no_such_flow_of", name=name, count=len(choose.to), flow=value.choice)
