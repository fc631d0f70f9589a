"""Who holds which subsystem: one session at a time may change it, the others watch; stop is for everybody (law 27)."""

from collections.abc import Iterable

from onika.host import edit
from onika.host.helm import Helm
from onika.host.stage import Stage, Tell
from onika.wire import event, live, request, steer

_HOLDER_ONLY = (
    live.Change,
    live.Clear,
    live.Reinit,
    live.Swap,
    live.Set,
    live.Close,
    live.Release,
    request.Reply,
)
"""What changes a subsystem."""


class Holders:
    """Judges requests by who holds what; a session that is lost holds nothing any more."""

    def __init__(self, stage: Stage, tell: Tell, helm: Helm) -> None:
        self._stage = stage
        self._tell = tell
        self._helm = helm

    def refusal(self, session: str, asked: request.Request, is_stopped: bool) -> str:
        """Why this session may not ask this now; empty: it may."""
        if isinstance(asked, live.Reset):
            return self._foreign(session)
        if isinstance(asked, steer.Steering):
            return self._helm.refusal(session, asked)
        if not isinstance(asked, _HOLDER_ONLY):
            return ""
        if is_stopped and isinstance(asked, live.Change) and (asked.on or asked.spawn):
            return "the runtime is stopped; reset it first"
        holder, application = self._holder(asked.subsystem)
        if application and not isinstance(asked, request.Reply):
            return f"application {application} runs in subsystem {asked.subsystem}; let it end, or abort it"
        if holder and holder != session:
            return f"subsystem {asked.subsystem} is held by {holder}; it can release it, everybody can stop"
        return ""

    def occupied(self, session: str, names: Iterable[str]) -> str:
        """Why an application may not begin in these subsystems; empty: all are free, or hold nothing."""
        for name in names:
            holder, application = self._holder(name)
            if application:
                return f"application {application} runs in subsystem {name} already; let it end, or abort it"
            if holder and holder != session:
                return f"subsystem {name} is held by {holder}; it can release it, or use another subsystem"
            if name in self._stage.live:
                tasks = ", ".join(self._stage.live[name].members)
                if tasks:
                    return f"subsystem {name} has tasks already ({tasks}); kill them, or use another subsystem"
                self._stage.drop(name)
        return ""

    def takes(self, session: str, subsystem: str, response: request.Response) -> request.Response:
        """Whoever changes a subsystem that nobody holds becomes its holder."""
        if isinstance(response, live.Accepted):
            self._give(subsystem, session)
        return response

    def change(self, session: str, asked: live.Take | live.Release) -> request.Response:
        """Take a subsystem, or let another take it."""
        holder, application = self._holder(asked.subsystem)
        if isinstance(asked, live.Release):
            if asked.subsystem in self._stage.live:
                self._leave(asked.subsystem)
            return request.Done()
        if application or (holder and holder != session):
            return request.Refused(f"subsystem {asked.subsystem} is held by {holder}")
        self._stage.by_hand(asked.subsystem)
        self._give(asked.subsystem, session)
        return request.Done()

    def lost(self, session: str, now: int) -> None:
        """A session is gone: its runs end unless they were begun to go on; what it held by hand comes to rest."""
        cause = f"the session {session} that began it is gone"
        for performance in self._stage.performances:
            if performance.session == session:
                performance.session = ""
                performance.abandon(cause, now)
        for name, subsystem in list(self._stage.live.items()):
            if subsystem.holder == session:
                subsystem.begin(0, edit.rest(subsystem))
                self._leave(name)

    def _holder(self, subsystem: str) -> tuple[str, str]:
        """The session that holds it and the application that runs in it."""
        performance = self._stage.performance_in(subsystem)
        if performance is not None:
            return performance.session, performance.application
        by_hand = self._stage.live.get(subsystem)
        return (by_hand.holder if by_hand is not None else ""), ""

    def _foreign(self, session: str) -> str:
        """Whether others hold something and this session does not: then it is not its stop to leave."""
        holders = {one.holder for one in self._stage.live.values()} | {one.session for one in self._stage.performances}
        holders.discard("")
        if holders and session not in holders:
            return f"only a holder ({', '.join(sorted(holders))}) leaves a stop"
        return ""

    def _leave(self, subsystem: str) -> None:
        """Nobody holds it any more; if nothing is left of it either, it is no more."""
        self._give(subsystem, "")
        if self._stage.live[subsystem].is_empty:
            self._stage.drop(subsystem)

    def _give(self, subsystem: str, session: str) -> None:
        one = self._stage.live[subsystem]
        if one.holder != session:
            one.holder = session
            self._tell(event.Held(subsystem, session), subsystem, session)
