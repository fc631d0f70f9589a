"""What people ask by hand: edits of configurations, who holds what, and what hands do in a workcell."""

from collections.abc import Callable, Iterable
from time import monotonic_ns

from onika.host.driver import Driver
from onika.host.edit.editor import LiveEditor, refused
from onika.host.sessions.control_authority import ControlAuthority
from onika.host.sessions.presence import Presence
from onika.host.subsystems.motion import Motion
from onika.host.subsystems.pads import Pads
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.host.subsystems.world_reset import WorldReset
from onika.wire import event, holding, live, request
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault
from onika.words.reason import reason_of


class HandRequests:
    """Answered at once. `offer` keeps the files of worlds, and tells of those that are open and made of others.

    What hands have touched is told to everybody.
    """

    def __init__(
        self,
        subsystems: Subsystems,
        driver: Driver,
        editor: LiveEditor,
        authority: ControlAuthority,
        motion: Motion,
        presence: Presence,
        offer: Callable[[Iterable[WorldSource]], list[Fault]],
        tell: Callable[[event.Event], None],
    ) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._editor = editor
        self._authority = authority
        self._motion = motion
        self._presence = presence
        self._offer = offer
        self._tell = tell
        self._pads = Pads(subsystems)
        self._world_reset = WorldReset(subsystems, driver)

    def answer(self, session: str, message: request.Request) -> request.Response | None:
        """The answer; None where it is asked of somebody else."""
        match message:
            case live.Change():
                if faults := self._offer(message.worlds):
                    return refused(faults, [])
                return self._authority.takes(session, message.subsystem, self._editor.change(message))
            case live.Reinit() | live.Swap() | live.Clear() | live.Write() | live.Close():
                return self._edited(message)
            case live.Touch() | live.PutBack() | live.Push():
                return self._in_workcell(session, message)
            case live.Reset():
                self._motion.allow(session)
                return request.Done()
            case live.Take() | live.Release():
                return self._authority.change(session, message)
        return self._of_holders(session, message)

    def _edited(self, message: live.Reinit | live.Swap | live.Clear | live.Write | live.Close) -> request.Response:
        match message:
            case live.Reinit():
                return self._editor.reinit(message)
            case live.Swap():
                return self._editor.swap(message)
            case live.Clear():
                return self._editor.clear(message)
            case live.Write():
                return self._editor.write(message)
            case live.Close():
                return self._editor.close(message)

    def _in_workcell(self, session: str, message: live.Touch | live.PutBack | live.Push) -> request.Response:
        """What hands do in a workcell, or at a pad."""
        if isinstance(message, live.Push):
            return self._pads.push(session, message, self._driver.now)
        if isinstance(message, live.PutBack):
            return self._world_reset.answer(session, message)
        try:
            self._driver.touch(message.world, message.part, message.value)
        except ValueError as wrong:
            return request.Refused(reason_of(wrong))
        self._tell(event.Touched(message.world, message.part, message.value, self._driver.now * 1e-9))
        return request.Done()

    def _of_holders(self, session: str, message: request.Request) -> request.Response | None:
        match message:
            case holding.Hand():
                return self._authority.hand(session, message, monotonic_ns())
            case holding.Decline():
                return self._authority.decline(session, message)
            case holding.OnlyWatch():
                return self._authority.only_watch(session)
            case holding.Sessions():
                return self._presence.answer(session)
        return None
