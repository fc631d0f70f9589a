"""Who holds which subsystem: one session at a time may change it, the others watch; stop is for everybody (law 27)."""

from collections.abc import Callable, Iterable, Sequence
from typing import get_args

from onika.host.edit import transactions
from onika.host.run.application_run import ApplicationRun
from onika.host.sessions.dependents import runs_of, subsystems_of
from onika.host.sessions.handover import Offer, Offers
from onika.host.sessions.permission import changes_nothing
from onika.host.subsystems.run_commands import RunCommands
from onika.host.subsystems.subsystem_registry import Subsystems, Tell
from onika.link.caller import Role
from onika.wire import event, holding, live, request, steer
from onika.words.reason import NOTHING, Reason

_HOLDER_ONLY = (
    *(live.Change, live.Clear, live.Reinit, live.Swap, live.Set, live.Write, live.Close, live.Release),
    request.Reply,
)
"""What changes a subsystem."""

_FENCED = (
    *(one for one in _HOLDER_ONLY if one is not live.Release),
    *get_args(steer.Steering),
    holding.Hand,
    live.Push,
)
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

    def refusal(self, session: str, message: request.Request, is_stopped: bool) -> Reason:
        """Why this session may not ask this now; empty: it may."""
        if session in self.watching and not changes_nothing(message):
            return Reason.of("host.watches_only")
        if session in self._lapsed and isinstance(message, _FENCED):
            return Reason.of("host.holder_lapsed")
        if isinstance(message, live.Reset):
            return self._foreign(session)
        if isinstance(message, steer.Steering):
            return self._run_commands.refusal(session, message)
        if not isinstance(message, _HOLDER_ONLY):
            return NOTHING
        if is_stopped and isinstance(message, live.Change) and (message.on or message.spawn):
            return Reason.of("host.is_stopped")
        return self._refusal_of_change(session, message.subsystem, is_answer=isinstance(message, request.Reply))

    def _refusal_of_change(self, session: str, subsystem: str, *, is_answer: bool) -> Reason:
        """Why this session may not change this subsystem, or answer in it; an application may be answered."""
        holder, application = self._holder(subsystem)
        if application and not is_answer:
            return Reason.of("host.runs_in", application=application, subsystem=subsystem)
        if holder and holder != session:
            return Reason.of("host.held_stop", subsystem=subsystem, holder=holder)
        return NOTHING

    def occupied(self, session: str, names: Iterable[str]) -> Reason:
        """Why an application may not begin in these subsystems; empty: all are free, or hold nothing."""
        for name in names:
            holder, application = self._holder(name)
            if application:
                return Reason.of("host.runs_in_already", application=application, subsystem=name)
            if holder and holder != session:
                return Reason.of("host.held_elsewhere", subsystem=name, holder=holder)
            if name in self._subsystems.live:
                tasks = tuple(self._subsystems.live[name].members)
                if tasks:
                    return Reason.of("host.has_tasks", subsystem=name, tasks=tasks)
                self._subsystems.drop(name)
        return NOTHING

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
        if holder != session:
            hand_held = Reason.of("host.hand_held", subsystem=name, holder=holder)
            return request.Refused(hand_held if holder else Reason.of("host.hand_free", subsystem=name))
        if not message.to:
            if self._offer(name) is None:
                return request.Refused(Reason.of("host.offered_nobody", subsystem=name))
            self._offers.end(name, Reason.of("host.offer_withdrawn"))
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
            return request.Refused(Reason.of("host.offers_nobody", subsystem=message.subsystem))
        self._offers.end(message.subsystem, Reason.of("host.offer_declined", session=session))
        return request.Done()

    def only_watch(self, session: str) -> request.Response:
        """From now on the session changes nothing."""
        held = [name for name, one in self._subsystems.live.items() if one.holder == session]
        held += [name for run in self._subsystems.runs if run.session == session for name in run.names]
        if held:
            return request.Refused(Reason.of("host.holds_still", names=tuple(sorted(held))))
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
        cause = Reason.of("host.holder_silent", session=session, seconds=silent_ns * 1e-9)
        for run in runs_of(session, self._subsystems.runs, is_silent=True):
            self._abandon(run, cause, session, now)
        self._rest(session, cause)

    def lost(self, session: str, now: int) -> None:
        """A session is gone: its runs end unless they were begun to go on; what it held by hand comes to rest."""
        cause = Reason.of("host.run_deserted", session=session)
        for run in runs_of(session, self._subsystems.runs, is_silent=False):
            self._abandon(run, cause, session, now)
        self._rest(session, Reason.of("host.holder_gone", session=session))

    def users(self) -> set[str]:
        """Those of whom a session holds something."""
        return {session.partition("#")[0] for session in self._holders()}

    def end_use(self, user: str, late: str, cause: Reason, now: int) -> None:
        """The time of a user is over: his runs `stop`, or `finish` their actions and pause; what he holds rests."""
        for session in sorted(one for one in self._holders() if one.partition("#")[0] == user):
            for run in [run for run in self._subsystems.runs if run.session == session]:
                run.on_loss = late
                self._abandon(run, cause, session, now)
            self._rest(session, cause)

    def _abandon(self, run: ApplicationRun, cause: Reason, session: str, now: int) -> None:
        """A run is nobody's: it goes as it was begun to go, and others may take it."""
        run.abandon(cause, now)
        for name in run.names:
            self._tell(event.Held(name, "", cause), name, session)

    def _rest(self, session: str, cause: Reason) -> None:
        """What a session held by hand comes to rest, and is nobody's."""
        self._offers.leave(session)
        holders = {name: subsystem.holder for name, subsystem in self._subsystems.live.items()}
        for name in subsystems_of(session, holders):
            subsystem = self._subsystems.live[name]
            subsystem.begin(0, transactions.rest(subsystem))
            self._leave(name, cause)

    def _take(self, session: str, name: str) -> Reason:
        """Take what is offered, what nobody holds, or a run that is nobody's any more; why not, or nothing."""
        holder, application = self._holder(name)
        offer = self._offer(name)
        if offer is not None and offer.to == session:
            self._offers.end(name, Reason.of("host.offer_accepted"))
            return self._pass_on(name, session, Reason.of("host.handed_over", holder=holder))
        if application and not holder:
            return self._pass_on(name, session, Reason.of("host.run_of_nobody"))
        if application or (holder and holder != session):
            return Reason.of("host.held_by", subsystem=name, holder=holder)
        self._subsystems.by_hand(name)
        self._give(name, session)
        return NOTHING

    def _pass_on(self, name: str, session: str, cause: Reason) -> Reason:
        """What is there goes on; only who may change it is another. A run is passed on with all its subsystems."""
        run = self._subsystems.run_in(name)
        if run is None:
            self._give(name, session, cause)
            return NOTHING
        self._subsystems.hold.release(run.session)
        run.pass_on(session)
        for subsystem in run.names:
            self._offers.end(subsystem, Reason.of("host.offer_passed_on"))
            self._tell(event.Held(subsystem, session, cause), subsystem, session)
        return NOTHING

    def _offer(self, subsystem: str) -> Offer | None:
        """What its present holder offers of it."""
        offer = self._offers.find(subsystem)
        if offer is not None and offer.holder != self._holder(subsystem)[0]:
            self._offers.end(subsystem, Reason.of("host.offer_overtaken"))
            return None
        return offer

    def _meant(self, session: str, to: str) -> tuple[str, Reason]:
        """The session of that name, or the only one of that user; or why it can be none."""
        others = [standing for standing in self._sessions() if standing.name != session and standing.is_here]
        matches = [other for other in others if other.name == to] or [
            other for other in others if other.name.split("#")[0] == to
        ]
        if len(matches) != 1:
            names = tuple(standing.name for standing in matches or others)
            handed_to = Reason.of("host.handed_to", names=names, to=to)
            return "", handed_to if names else Reason.of("host.handed_alone", to=to)
        (match,) = matches
        if match.role == Role.VIEWER.word or match.only_watches:
            return "", Reason.of("host.takes_nothing", name=match.name)
        return match.name, NOTHING

    def _holder(self, subsystem: str) -> tuple[str, str]:
        """The session that holds it and the application that runs in it."""
        run = self._subsystems.run_in(subsystem)
        if run is not None:
            return run.session, run.application
        by_hand = self._subsystems.live.get(subsystem)
        return (by_hand.holder if by_hand is not None else ""), ""

    def _holders(self) -> set[str]:
        by_hand = {one.holder for one in self._subsystems.live.values()}
        return (by_hand | {run.session for run in self._subsystems.runs}) - {""}

    def _foreign(self, session: str) -> Reason:
        """Whether others hold something and this session does not: then it is not its stop to leave."""
        holders = self._holders()
        if holders and session not in holders:
            return Reason.of("host.stop_of_holder", names=tuple(sorted(holders)))
        return NOTHING

    def _leave(self, subsystem: str, cause: Reason = NOTHING) -> None:
        """Nobody holds it any more; if nothing is left of it either, it is no more."""
        self._give(subsystem, "", cause)
        if self._subsystems.live[subsystem].is_empty:
            self._subsystems.drop(subsystem)

    def _give(self, subsystem: str, session: str, cause: Reason = NOTHING) -> None:
        one = self._subsystems.live[subsystem]
        if one.holder != session:
            former, one.holder = one.holder, session
            self._offers.end(subsystem, Reason.of("host.offer_released"))
            self._tell(event.Held(subsystem, session, cause), subsystem, session or former)
