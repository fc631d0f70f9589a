"""Look-ahead: where a flow goes for each value its current action may return, so that the switch can be prepared."""

from collections.abc import Iterator

from onika.engine.program import FlowProgram
from onika.engine.walk import FinishValue, WalkResult, walk
from onika.wire.plan import Choose

_MOST_CHOICES = 4
"""More ways than these are not prepared: each costs a switch that is made ready and mostly not used."""


class _Unforeseen(Exception):
    """The way depends on a part of the value, which this names, or on a condition."""


class _Open:
    """A value of which a part is not known."""

    def __init__(self, choice: int | None, loop: bool | None) -> None:
        self._choice = choice
        self._loop = loop

    @property
    def choice(self) -> int:
        if self._choice is None:
            raise _Unforeseen("choice")
        return self._choice

    @property
    def loop(self) -> bool:
        if self._loop is None:
            raise _Unforeseen("loop")
        return self._loop


def ways(
    program: FlowProgram, pc: int, leaving: frozenset[str]
) -> Iterator[tuple[int | None, bool | None, WalkResult]]:
    """The way from `pc` on for every value of (choice, loop) that makes a difference; none: whatever it is.

    Nothing where a condition decides, or too many ways lead on.
    """
    yield from _ways(program, pc, leaving, None, None)


def _ways(
    program: FlowProgram, pc: int, leaving: frozenset[str], choice: int | None, loop: bool | None
) -> Iterator[tuple[int | None, bool | None, WalkResult]]:
    open_value: FinishValue = _Open(choice, loop)  # type: ignore[assignment]  # it has what a walk looks at
    try:
        way = walk(program, pc, open_value, leaving, _nobody_knows, lambda _action: False)
    except _Unforeseen as unforeseen:
        if unforeseen.args == ("loop",):
            for loop_ in (False, True):
                yield from _ways(program, pc, leaving, choice, loop_)
        elif unforeseen.args == ("choice",):
            for choice_ in range(min(_widest(program), _MOST_CHOICES)):
                yield from _ways(program, pc, leaving, choice_, loop)
        return
    if not way.notes and not way.is_endless:
        yield choice, loop, way


def _nobody_knows(_condition: str) -> bool:
    raise _Unforeseen("condition")


def _widest(program: FlowProgram) -> int:
    return max(
        (len(instruction.to) for instruction in program.instructions if isinstance(instruction, Choose)), default=0
    )
