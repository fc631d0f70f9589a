"""Watches variables: reads them again and again, and shows each change (requirement A16)."""

from typing import Any

from onika.desk.console import control_lines
from onika.desk.console.display import Tone
from onika.desk.console.inspection import value
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.task_lines import positive
from onika.desk.run.value_text import shown
from onika.words.reason import Reason

Words = tuple[str, ...]
_USUAL_HZ = 2.0
_MOST_HZ = 20.0


class VariableWatch:
    """What is watched, how often, and what was shown last."""

    def __init__(self) -> None:
        self._names: Words = ()
        self._period_s = 1.0 / _USUAL_HZ
        self._due_s = 0.0
        self._shown: dict[tuple[str, str], Any] = {}

    def command(self, session: ConsoleSession, words: Words) -> Faults:
        """`watch NAME… [HZ]`; `watch off` ends it; without words it says what is watched; `watch only`: no changes."""
        if words == ("only",):
            return control_lines.only_watch(session)
        if words == ("off",):
            self._names = ()
            return ()
        if not words:
            watched = " ".join(self._names) or Reason.of("console.nothing")
            session.say(Reason.of("console.watched", names=watched), Tone.DIM)
            return ()
        return self._begin(session, words)

    def _begin(self, session: ConsoleSession, words: Words) -> Faults:
        """Watch these names from now on, at the rate that may stand behind them."""
        hz = positive(words[-1])
        names = words if hz is None else words[:-1]
        if (hz is not None and hz > _MOST_HZ) or not names:
            return session.no(Reason.of("console.watch_usage", hz=_MOST_HZ, words=" ".join(words)))
        for name in names:
            _, faults = value(session, *session.address(name))
            if faults:
                return faults
        self._names = tuple("/".join(session.address(name)) for name in names)
        self._period_s = 1.0 / (hz or _USUAL_HZ)
        self._shown = {}
        self._due_s = 0.0
        self.tick(session)
        return ()

    def tick(self, session: ConsoleSession) -> None:
        """Show what has changed, when it is time to look."""
        if not self._names or session.clock() < self._due_s:
            return
        self._due_s = session.clock() + self._period_s
        for name in self._names:
            address = session.address(name)
            current, faults = value(session, *address)
            if faults:
                self._names = ()
                session.say(Reason.of("console.no_more_watched", name=name, reason=faults[0].reason), Tone.NOTE)
                return
            if address not in self._shown or self._shown[address] != current:
                self._shown[address] = current
                for line in shown(name, current):
                    session.say(Reason.plain(line), Tone.DIM)
