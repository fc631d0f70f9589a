"""Who holds which subsystem: one session at a time may change it, the others watch; stop is for everybody (law 27)."""

from collections.abc import Callable, Iterable, Sequence
from typing import get_args

from onika.host.edit import transactions
from onika.host.run.application_run import ApplicationRun
from onika.host.sessions.handover import Offer, Offers
from onika.host.sessions.permission import changes_nothing
from onika.host.subsystems.run_commands import RunCommands
from onika.host.subsystems.subsystem_registry import Subsystems, Tell
from onika.link.caller import Role
from onika.wire import event, holding, live, request, steer

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

_FENCED = (*(one for one in _HOLDER_ONLY if one is not live.Release), *get_args(steer.Steering), holding.Hand)
"""What may have been meant for a moment that is long past; nothing moves again before somebody says so."""


class ControlAuthority:
    """Judges requests by who holds what; a session that is lost, or silent for too long, holds nothing any more."""

    def __init__(
        self,
        subsystems: Subsystems,
        tell: Tell,
        run_commands: RunCommands,
        sessions: Callable[[], Sequence[holding.SessionStanding]],
    ) -> None:
        self._subsystems = subsystems
        self._tell = tell
        self._run_commands = run_commands
        self._sessions = sessions
        self._offers = Offers(tell)
        self._lapsed: set[str] = set()
        self.watching: set[str] = set()
        """The sessions that have said that they only watch."""

    @property
    def needed(self) -> set[str]:
        """The sessions on whose being there something depends; a run that was begun to go on depends on nobody."""
        by_hand = {one.holder for one in self._subsystems.live.values()}
        return (by_hand | {run.session for run in self._subsystems.runs if run.on_loss != "run"}) - {""}

    def refusal(self, session: str, message: request.Request, is_stopped: bool) -> str:
        """Why this session may not ask this now; empty: it may."""
        if session in self.watching and not changes_nothing(message):
            return "this session only watches, as it has said; connect anew to change something"
        if session in self._lapsed and isinstance(message, _FENCED):
            return "this session held something and was not heard for too long; take a subsystem to go on"
        if isinstance(message, live.Reset):
            return self._foreign(session)
        if isinstance(message, steer.Steering):
            return self._run_commands.refusal(session, message)
        if not isinstance(message, _HOLDER_ONLY):
            return ""
        if is_stopped and isinstance(message, live.Change) and (message.on or message.spawn):
            return "the runtime is stopped; reset it first"
        holder, application = self._holder(message.subsystem)
        if application and not isinstance(message, request.Reply):
            return f"application {application} runs in subsystem {message.subsystem}; let it end, or abort it"
        if holder and holder != session:
            return f"subsystem {message.subsystem} is held by {holder}; it can release it, everybody can stop"
        return ""

    def occupied(self, session: str, names: Iterable[str]) -> str:
        """Why an application may not begin in these subsystems; empty: all are free, or hold nothing."""
        for name in names:
            holder, application = self._holder(name)
            if application:
                return f"application {application} runs in subsystem {name} already; let it end, or abort it"
            if holder and holder != session:
                return f"subsystem {name} is held by {holder}; it can release it, or use another subsystem"
            if name in self._subsystems.live:
                tasks = ", ".join(self._subsystems.live[name].members)
                if tasks:
                    return f"subsystem {name} has tasks already ({tasks}); kill them, or use another subsystem"
                self._subsystems.drop(name)
        return ""

    def takes(self, session: str, subsystem: str, response: request.Response) -> request.Response:
        """Whoever changes a subsystem that nobody holds becomes its holder."""
        if isinstance(response, live.Accepted):
            self._give(subsystem, session)
        return response

    def change(self, session: str, message: live.Take | live.Release) -> request.Response:
        """Take a subsystem, or let another take it."""
        if isinstance(message, live.Release):
            if message.subsystem in self._subsystems.live:
                self._leave(message.subsystem)
            return request.Done()
        refused = self._take(session, message.subsystem)
        if refused:
            return request.Refused(refused)
        self._lapsed.discard(session)
        return request.Done()

    def hand(self, session: str, message: holding.Hand, wall_ns: int) -> request.Response:
        """Offer a subsystem to another session, or offer it no more."""
        name = message.subsystem
        holder, _ = self._holder(name)
        if not holder or holder != session:
            return request.Refused(f"subsystem {name} is held by {holder or 'nobody'}; only its holder hands it over")
        if not message.to:
            if self._offer(name) is None:
                return request.Refused(f"nobody is offered subsystem {name}")
            self._offers.end(name, "withdrawn")
            return request.Done()
        to, why = self._meant(session, message.to)
        if why:
            return request.Refused(why)
        self._offers.put(name, session, to, wall_ns)
        return request.Done()

    def decline(self, session: str, message: holding.Decline) -> request.Response:
        """Say no to an offer."""
        offer = self._offer(message.subsystem)
        if offer is None or offer.to != session:
            return request.Refused(f"nobody offers subsystem {message.subsystem} to this session")
        self._offers.end(message.subsystem, f"{session} declines")
        return request.Done()

    def only_watch(self, session: str) -> request.Response:
        """From now on the session changes nothing."""
        held = [name for name, one in self._subsystems.live.items() if one.holder == session]
        held += [name for run in self._subsystems.runs if run.session == session for name in run.names]
        if held:
            return request.Refused(f"this session holds {', '.join(sorted(held))}; release it first, or let it end")
        self.watching.add(session)
        return request.Done()

    def began(self, session: str) -> None:
        """A session has begun a run that was prepared since it is heard again."""
        self._lapsed.discard(session)

    def expire(self, wall_ns: int) -> None:
        """Let time pass for what is offered."""
        self._offers.expire(wall_ns)

    def lapse(self, session: str, silent_ns: int, now: int) -> None:
        """A holder was silent for too long: what it drives comes to rest, and others may take it.

        When it is heard again it may look; for anything else it takes a subsystem, or prepares a run, anew.
        """
        self._lapsed.add(session)
        cause = f"its holder {session} has been silent for {silent_ns * 1e-9:.2f} s"
        for run in self._subsystems.runs:
            if run.session == session and run.on_loss != "run":
                self._abandon(run, cause, session, now)
        self._rest(session, cause)

    def lost(self, session: str, now: int) -> None:
        """A session is gone: its runs end unless they were begun to go on; what it held by hand comes to rest."""
        cause = f"the session {session} that began it is gone"
        for run in self._subsystems.runs:
            if run.session == session:
                self._abandon(run, cause, session, now)
        self._rest(session, f"its holder {session} is gone")

    def _abandon(self, run: ApplicationRun, cause: str, session: str, now: int) -> None:
        """A run is nobody's: it goes as it was begun to go, and others may take it."""
        run.session = ""
        run.abandon(cause, now)
        for name in run.names:
            self._tell(event.Held(name, "", cause), name, session)

    def _rest(self, session: str, cause: str) -> None:
        """What a session held by hand comes to rest, and is nobody's."""
        self._offers.leave(session)
        for name, subsystem in list(self._subsystems.live.items()):
            if subsystem.holder == session:
                subsystem.begin(0, transactions.rest(subsystem))
                self._leave(name, cause)

    def _take(self, session: str, name: str) -> str:
        """Take what is offered, what nobody holds, or a run that is nobody's any more; why not, or nothing."""
        holder, application = self._holder(name)
        offer = self._offer(name)
        if offer is not None and offer.to == session:
            self._offers.end(name, "accepted")
            return self._pass_on(name, session, f"{holder} has handed it over")
        if application and not holder:
            return self._pass_on(name, session, "nobody held its run")
        if application or (holder and holder != session):
            return f"subsystem {name} is held by {holder}"
        self._subsystems.by_hand(name)
        self._give(name, session)
        return ""

    def _pass_on(self, name: str, session: str, cause: str) -> str:
        """What is there goes on; only who may change it is another. A run is passed on with all its subsystems."""
        run = self._subsystems.run_in(name)
        if run is None:
            self._give(name, session, cause)
            return ""
        self._subsystems.hold.release(run.session)
        run.session = session
        for subsystem in run.names:
            self._offers.end(subsystem, "its run was passed on")
            self._tell(event.Held(subsystem, session, cause), subsystem, session)
        return ""

    def _offer(self, subsystem: str) -> Offer | None:
        """What its present holder offers of it."""
        offer = self._offers.find(subsystem)
        if offer is not None and offer.holder != self._holder(subsystem)[0]:
            self._offers.end(subsystem, "it is held by another")
            return None
        return offer

    def _meant(self, session: str, to: str) -> tuple[str, str]:
        """The session of that name, or the only one of that user; or why it can be none."""
        others = [standing for standing in self._sessions() if standing.name != session and standing.is_here]
        matches = [other for other in others if other.name == to] or [
            other for other in others if other.name.split("#")[0] == to
        ]
        if len(matches) != 1:
            names = ", ".join(standing.name for standing in matches or others) or "nobody else"
            return "", f"expected one of those who are there ({names}), found {to}"
        if matches[0].role == Role.VIEWER.word or matches[0].only_watches:
            return "", f"{matches[0].name} only watches and can take nothing"
        return matches[0].name, ""

    def _holder(self, subsystem: str) -> tuple[str, str]:
        """The session that holds it and the application that runs in it."""
        run = self._subsystems.run_in(subsystem)
        if run is not None:
            return run.session, run.application
        by_hand = self._subsystems.live.get(subsystem)
        return (by_hand.holder if by_hand is not None else ""), ""

    def _foreign(self, session: str) -> str:
        """Whether others hold something and this session does not: then it is not its stop to leave."""
        holders = {one.holder for one in self._subsystems.live.values()} | {
            run.session for run in self._subsystems.runs
        }
        holders.discard("")
        if holders and session not in holders:
            return f"only a holder ({', '.join(sorted(holders))}) leaves a stop"
        return ""

    def _leave(self, subsystem: str, cause: str = "") -> None:
        """Nobody holds it any more; if nothing is left of it either, it is no more."""
        self._give(subsystem, "", cause)
        if self._subsystems.live[subsystem].is_empty:
            self._subsystems.drop(subsystem)

    def _give(self, subsystem: str, session: str, cause: str = "") -> None:
        one = self._subsystems.live[subsystem]
        if one.holder != session:
            former, one.holder = one.holder, session
            self._offers.end(subsystem, "it is released")
            self._tell(event.Held(subsystem, session, cause), subsystem, session or former)
