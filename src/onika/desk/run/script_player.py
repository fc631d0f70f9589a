"""The script player: carries out the lines of a script one by one while a run goes on (requirements E07, E13)."""

from collections import deque
from collections.abc import Callable

from onika.desk.run.pending_wait import PendingWait
from onika.desk.run.running_application import Running
from onika.desk.run.steering import PositionQuery, SteeringWait
from onika.desk.run.steering_script import ScriptLine
from onika.wire.steer import Position
from onika.words.fault import Fault
from onika.words.reason import Reason

LineListener = Callable[[str, tuple[Fault, ...], tuple[Position, ...]], None]
"""A line that is carried out, what is wrong with it, and the positions where it asked for them."""


class ScriptPlayer:
    """Whenever something has happened, `go_on` carries out the next line if its turn has come.

    The first line that fails ends the script, and the run with it.
    """

    def __init__(self, running: Running, script_lines: tuple[ScriptLine, ...], output: LineListener) -> None:
        self._running = running
        self._script_lines = deque(script_lines)
        self._told = output
        self._pending_wait: PendingWait | None = None

    @property
    def is_over(self) -> bool:
        """Whether no line is left."""
        return not self._script_lines

    @property
    def until_s(self) -> float | None:
        """The time at which the next line is looked at again, whatever happens."""
        if self._pending_wait is None:
            return None
        return self._pending_wait.until_s

    def go_on(self) -> bool:
        """Carry out the next line if its turn has come; whether it has."""
        running = self._running
        if running.is_aborted:
            self._script_lines.clear()  # why is told by the result
        if not self._script_lines or not self._can_act:
            return False
        script_line = self._script_lines[0]
        if isinstance(script_line.act, SteeringWait):
            if self._pending_wait is None:
                self._pending_wait = running.pending_wait(script_line.act)
            if not self._pending_wait.is_over:
                return False
            faults, self._pending_wait = self._pending_wait.faults(script_line.place), None
        else:
            faults = running.do(script_line.act, script_line.place)
        self._script_lines.popleft()
        positions = running.who() if isinstance(script_line.act, PositionQuery) and not faults else ()
        if script_line.text or faults:
            self._told(script_line.text, faults, positions)
        if faults:
            self._fail(faults)
        return True

    @property
    def _can_act(self) -> bool:
        """In a held run only while the clock stands; no line is carried out while a task asks."""
        running = self._running
        if running.is_over:
            return True
        return (running.stands or not running.is_held) and not running.flow_tracker.is_asking

    def _fail(self, faults: tuple[Fault, ...]) -> None:
        self._script_lines.clear()
        self._running.outcome.failed += faults
        if not self._running.is_over:
            self._running.abort(Reason.of("desk.script_fails", place=str(faults[0].place)))
