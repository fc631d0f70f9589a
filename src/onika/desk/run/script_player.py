"""The prompter: carries out a script while its run goes on, one line after another (requirements E07, E13)."""

from collections import deque
from collections.abc import Callable

from onika.desk.run.pending_wait import Vigil
from onika.desk.run.running_application import Running
from onika.desk.run.steering import Look, Wait
from onika.desk.run.steering_script import Cue
from onika.wire.steer import Position
from onika.words.fault import Fault

Told = Callable[[str, tuple[Fault, ...], tuple[Position, ...]], None]
"""A line that is carried out, what is wrong with it, and the positions where it asked for them."""


class Prompter:
    """Whenever something has happened, `go_on` carries out the next line if its turn has come.

    The first line that fails ends the script, and the run with it.
    """

    def __init__(self, running: Running, cues: tuple[Cue, ...], output: Told) -> None:
        self._running = running
        self._cues = deque(cues)
        self._told = output
        self._vigil: Vigil | None = None

    @property
    def is_over(self) -> bool:
        """Whether no line is left."""
        return not self._cues

    @property
    def until_s(self) -> float | None:
        """The time at which the next line is looked at again, whatever happens."""
        return None if self._vigil is None else self._vigil.until_s

    def go_on(self) -> bool:
        """Carry out the next line if its turn has come; whether it has."""
        running = self._running
        if running.is_aborted:
            self._cues.clear()  # why is told by the result
        if not self._cues or not self._can_act:
            return False
        cue = self._cues[0]
        if isinstance(cue.act, Wait):
            if self._vigil is None:
                self._vigil = running.vigil(cue.act)
            if not self._vigil.is_over:
                return False
            faults, self._vigil = self._vigil.faults(cue.place), None
        else:
            faults = running.do(cue.act, cue.place)
        self._cues.popleft()
        positions = running.who() if isinstance(cue.act, Look) and not faults else ()
        self._told(cue.text, faults, positions)
        if faults:
            self._fail(faults)
        return True

    @property
    def _can_act(self) -> bool:
        """In a held run only while the clock stands; no line is carried out while a task asks."""
        running = self._running
        if running.is_over:
            return True
        return (running.stands or not running.is_held) and not running.whereabouts.is_asking

    def _fail(self, faults: tuple[Fault, ...]) -> None:
        self._cues.clear()
        self._running.outcome.failed += faults
        if not self._running.is_over:
            self._running.abort(f"the script fails at {faults[0].place}")
