"""What Onika's own work costs in instructions of Python and calls into C: the same on a machine that is busy."""

import gc
import sys
from collections.abc import Callable
from types import FrameType
from typing import Any

from beside.loop.onika_blocks import Loop
from beside.sequence.onika_application import Application
from beside.sequence.onika_sweep import Sweep
from onika.runtime.execution.whereabouts import Whereabouts

_STEPS = 40
_STEADY = 200
"""Instants after which everything that stays the same is swept."""


class Counter:
    """Counts what a piece of work executes."""

    def __init__(self) -> None:
        self.count = 0

    def of(self, work: Callable[[], object]) -> int:
        """Instructions of Python, and calls into C, of one call."""
        self.count = 0
        traced, profiled, collects = sys.gettrace(), sys.getprofile(), gc.isenabled()
        gc.disable()
        sys.settrace(self._enter)
        sys.setprofile(self._call)
        try:
            work()
        finally:
            sys.setprofile(profiled)
            sys.settrace(traced)
            if collects:
                gc.enable()
        return self.count

    def _enter(self, frame: FrameType, _event: str, _given: Any) -> Callable[..., Any]:
        frame.f_trace_lines, frame.f_trace_opcodes = False, True
        return self._step

    def _step(self, _frame: FrameType, event: str, _given: Any) -> Callable[..., Any]:
        self.count += event == "opcode"
        return self._step

    def _call(self, _frame: FrameType, event: str, _given: Any) -> None:
        self.count += event == "c_call"


def counts() -> dict[str, float]:
    """Each kind of work by name; what comes once, such as the birth of tasks, is taken off."""
    counter = Counter()
    loop, swept = Loop(Whereabouts()), Sweep(24, Whereabouts())
    first = counter.of(lambda: loop.step(_STEPS))
    loop.step(_STEADY)
    swept.run(_STEADY)
    few, many = Application(6), Application(18)
    few.run()
    many.run()
    return {
        "a block of the loop, one by one": round(first / _STEPS / 4, 1),
        "a block of the loop, swept": round(counter.of(lambda: loop.step(_STEPS)) / _STEPS / 4, 1),
        "an idle task, swept": round(counter.of(lambda: swept.run(_STEPS)) / _STEPS / 24, 1),
        "an action more of an application": round((counter.of(many.run) - counter.of(few.run)) / 12, 1),
    }
