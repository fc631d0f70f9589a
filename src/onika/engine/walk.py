"""The walk of a flow from one action to the next: what tests, branches and no-ops on the way decide (Table 9).

It changes nothing. `Way.pc` is the next instruction that takes time or needs others: a Do of a job, Meet, Fork, Join,
Rest or Halt; or the one behind a no-op after which the flow is to rest.
"""

from collections.abc import Callable
from dataclasses import dataclass

from onika.engine.program import Program
from onika.wire.plan import Again, Choose, Do, Jump, Rest, Unless

Judge = Callable[[str], bool]
"""Whether a condition on variables holds now."""


@dataclass(frozen=True, slots=True)
class Value:
    """What the last action returned."""

    choice: int = 0
    loop: bool = False


NOOP = Value(0, loop=True)
"""What a no-op returns (requirement D11)."""


@dataclass(frozen=True, slots=True)
class Way:
    """Where a walk leads."""

    pc: int
    value: Value | None
    left: frozenset[str]
    """The loops that were to be left and have not been."""
    passed: tuple[int, ...] = ()
    """The no-ops on the way."""
    notes: tuple[str, ...] = ()
    rests: bool = False
    """Whether the flow is to rest here, behind a no-op."""
    is_endless: bool = False
    """Whether it goes round for ever without taking any time."""


def walk(
    program: Program,
    pc: int,
    value: Value | None,
    leaving: frozenset[str],
    judge: Judge,
    rests_after: Callable[[int], bool],
) -> Way:
    """From instruction `pc` on; without a value every loop is left and flow 0 is taken (readings 21 and 22).

    leaving      the loops that are to be left at their next test
    rests_after  whether the flow rests after this no-op
    """
    passed: list[int] = []
    notes: list[str] = []
    seen: set[tuple[int, Value | None, frozenset[str]]] = set()
    while True:
        instruction = program.instructions[pc]
        if (pc, value, leaving) in seen:
            return Way(pc, value, leaving, tuple(passed), tuple(notes), is_endless=True)
        seen.add((pc, value, leaving))
        match instruction:
            case Do() if program.is_noop[instruction.action]:
                passed.append(instruction.action)
                value = NOOP
                pc += 1
                if rests_after(instruction.action):
                    return Way(pc, value, leaving, tuple(passed), tuple(notes), rests=True)
            case Rest() if instruction.action >= 0 or (instruction.condition and not judge(instruction.condition)):
                pc += 1
            case Choose():
                choice, note = _choice(instruction, value, judge)
                notes += [note] if note else []
                pc = instruction.to[choice]
            case Again() | Unless():
                goes_on = instruction.loop not in leaving and _goes_on(instruction, value, judge)
                leaving -= {instruction.loop} if not goes_on else frozenset()
                pc = instruction.to if goes_on == isinstance(instruction, Again) else pc + 1
            case Jump():
                pc, leaving = (
                    (pc + 1, leaving - {instruction.loop}) if instruction.loop in leaving else (instruction.to, leaving)
                )
            case _:
                return Way(pc, value, leaving, tuple(passed), tuple(notes))


def _goes_on(instruction: Again | Unless, value: Value | None, judge: Judge) -> bool:
    if instruction.condition:
        return judge(instruction.condition)
    return value is not None and value.loop


def _choice(choose: Choose, value: Value | None, judge: Judge) -> tuple[int, str]:
    """Which way, and what is worth saying of it (reading 20)."""
    if choose.conditions:
        last = len(choose.to) - 1
        return next((at for at, condition in enumerate(choose.conditions) if judge(condition)), last), ""
    if value is None or len(choose.to) == 1:
        return 0, ""
    if value.choice < len(choose.to):
        return value.choice, ""
    flows = f"{choose.name or 'the branch'} has {len(choose.to)} flows"
    return 0, f"{flows} and the action before it asks for flow {value.choice}: flow 0 is taken"
