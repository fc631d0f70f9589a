"""A replay is played, paused, stepped and hastened; it says when its next line is due, and waits for nothing."""

from dataclasses import replace
from typing import Protocol

from msgspec import structs

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.replay.session_player import SessionPlayer
from onika.desk.environment.state.model import Model
from onika.files.state.session_log import LogLine
from onika.wire import act, view
from onika.words.reason import NOTHING, Reason

SLOWEST, FASTEST = 0.1, 1000.0
"""Seconds of the session in a second."""
_SHOWN = 20
"""Faults that a page is shown."""
_AT_ONCE = 20
"""Lines that are carried out before others get a turn."""


class Clock(Protocol):
    """Seconds that never go back."""

    def __call__(self) -> float:
        """Now."""
        ...


class ReplayControl:
    """Plays a session; whoever owns it calls `advance` often.

    file    the name of the log
    speed   seconds of the session in a second
    """

    def __init__(self, clock: Clock, file: str, speed: float = 1.0, *, is_playing: bool = True) -> None:
        self._clock = clock
        self._file = file
        self._speed = min(max(speed, SLOWEST), FASTEST)
        self._is_playing = is_playing
        self._left = 0
        """Lines to be carried out whatever the time: by Step, or up to the end."""
        self._since_s = clock()
        """When the last line was carried out."""
        self._player: SessionPlayer | None = None

    def begin(self, player: SessionPlayer) -> None:
        """Play this session from now on."""
        self._player = player
        self._since_s = self._clock()
        self._show(player, None)

    def steer(self, model: Model, command: act.SteerReplay, _outside: Services) -> Done | No:
        """Carry out what somebody wants of the replay."""
        player = self._player
        if player is None:
            return No(Reason.of("replay.none_here"))
        if command.speed:
            if not SLOWEST <= command.speed <= FASTEST:
                return No(Reason.of("replay.speed_range", least=SLOWEST, most=FASTEST, given=command.speed))
            self._speed = command.speed
        self._is_playing = command.wish == "play" and not player.is_over
        self._left = {"step": 1, "end": len(player.lines)}.get(command.wish, 0)
        self._since_s = self._clock()
        return Done(replace(model, replay=self._view(player, _last(player))))

    def advance(self) -> bool:
        """Carry out what is due, but not too much at one time; whether anything was."""
        player = self._player
        if player is None:
            return False
        count = 0
        while count < _AT_ONCE and self._is_due(player):
            count += 1
            self._carry_out_next(player)
        return count > 0

    def _carry_out_next(self, player: SessionPlayer) -> None:
        """Carry out a line, and show it: a page follows each."""
        self._since_s += player.wait_s / self._speed
        self._left = max(0, self._left - 1)
        line = player.step()
        if player.is_over:
            self._is_playing, self._left = False, 0
        if self._left or not self._is_playing:
            self._since_s = self._clock()
        self._show(player, line)

    def _is_due(self, player: SessionPlayer) -> bool:
        if player.is_over:
            return False
        return self._left > 0 or (self._is_playing and self._clock() - self._since_s >= player.wait_s / self._speed)

    def _show(self, player: SessionPlayer, line: LogLine | None) -> None:
        player.environment.become(lambda model: Done(replace(model, replay=self._view(player, line))))

    def _view(self, player: SessionPlayer, line: LogLine | None) -> view.ReplayView:
        lines = player.lines
        first_s = lines[0].at_s if lines else 0.0
        shown = view.ReplayView(
            self._file,
            player.position,
            len(lines),
            length_s=max((line.at_s for line in lines), default=0.0) - first_s,
            speed=self._speed,
            is_playing=self._is_playing,
            faults=tuple(fault.sentence for fault in player.faults[-_SHOWN:]),
            faults_in_all=len(player.faults),
        )
        if line is None:
            return shown
        return _with_line(shown, line, line.at_s - first_s)


def refusal(command: act.AnyAct) -> Reason:
    """Why an act of whoever looks at a replay is not done; empty: it is one that changes nothing."""
    return NOTHING if type(command) in _LOOKS else Reason.of("replay.only_watched")


_LOOKS: frozenset[type] = frozenset(
    (act.SteerReplay, act.Watch, act.Scene, act.Meshes, act.Peek, act.ListSets, act.ReadText, act.Stop)
)


def _last(player: SessionPlayer) -> LogLine | None:
    return player.lines[player.position - 1] if player.position else None


def _with_line(shown: view.ReplayView, line: LogLine, at_s: float) -> view.ReplayView:
    return structs.replace(
        shown,
        at_s=at_s,
        event=line.event,
        object=line.object,
        id=line.id,
        associated=line.associated,
        associated_id=line.associated_id,
        window=line.window,
    )
