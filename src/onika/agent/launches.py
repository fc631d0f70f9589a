"""What runs at a site, and who may change that: each launch is of the list of its owner, and runs once (A15, F09)."""

import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from onika.agent.attended_runtime import AttendedRuntime, RuntimeNews
from onika.booking.slots import Slots
from onika.link.caller import Role
from onika.model.launch import Launch
from onika.wire.booking import Booking
from onika.wire.site_card import LaunchCard, SiteCard, SiteHandOver
from onika.words.reason import Reason

READY_S = 30.0
"""How long whoever launches waits at most until the runtime is there."""
_END_S = 10.0


@dataclass(frozen=True, slots=True)
class Guest:
    """Who asks: a user of the site, and what he may."""

    name: str
    role: Role


class SiteRefusal(Exception):
    """It is not done; `reason` says why, `status` is that of HTTP."""

    def __init__(self, reason: Reason, status: int = 409) -> None:
        self.reason = reason
        self.status = status
        super().__init__(reason)


class BookedTimes(Protocol):
    """What is booked at the site."""

    def now_s(self) -> float:
        """The time there, in seconds of UTC since 1970."""
        ...

    def of(self, robot: str) -> Sequence[Booking]:
        """Those of a robot that are not over."""
        ...


class SiteLaunches:
    """Launches and ends the runtimes of a site; any thread may ask.

    begins      starts a runtime as the list says it
    """

    def __init__(
        self,
        site: str,
        identity: str,
        launches: Sequence[Launch],
        begins: Callable[[Launch, bool], AttendedRuntime],
        bookings: BookedTimes,
    ) -> None:
        self._site = site
        self._identity = identity
        self._launches: Mapping[str, Launch] = {launch.name: launch for launch in launches}
        self._begins = begins
        self._bookings = bookings
        self._lock = threading.Lock()
        self._runtimes: dict[str, AttendedRuntime] = {}
        self._is_over = False

    def card(self, guest: Guest) -> SiteCard:
        """What the site says of itself."""
        launches = tuple(self._card_of(launch) for launch in self._launches.values())
        now_s = self._bookings.now_s()
        return SiteCard(self._site, self._identity, now_s, guest.name, guest.role.word, launches)

    def launch(self, name: str, guest: Guest, *, stays: bool) -> SiteHandOver:
        """Have it run, and hand it over as soon as it does; one that runs already is joined. Raises SiteRefusal."""
        launch = self._of(name)
        self._judge(launch, guest)
        with self._lock:
            if self._is_over:
                raise SiteRefusal(Reason.of("site.ends", site=self._site), 503)
            runtime = self._runtimes.get(name)
            is_new = runtime is None or not runtime.expect_guest()
            if runtime is None or is_new:
                if runtime is not None:
                    runtime.join(_END_S)  # it may be ending, and has a port and a robot till then
                runtime = self._runtimes[name] = self._begins(launch, launch.stays or stays)
                runtime.start()
            elif stays:
                runtime.stays = True
        news = runtime.ready(READY_S)
        if news.state == "starting":
            runtime.end(Reason.of("site.not_started_in_time", seconds=READY_S))
            raise SiteRefusal(Reason.of("site.not_started_in_time", seconds=READY_S), 504)
        if not news.lives:
            raise SiteRefusal(Reason.of("site.not_launched", name=name, why=news.reason), 502)
        return SiteHandOver(self._site, self._identity, name, news.port, is_new, runtime.stays)

    def end(self, name: str, guest: Guest) -> None:
        """End it; raises SiteRefusal, also where others are there and the guest is not the owner."""
        self._of(name)
        runtime = self._runtimes.get(name)
        if guest.role < Role.OPERATOR:
            raise SiteRefusal(Reason.of("site.role_wanted", role=guest.role.word, user=guest.name), 403)
        if runtime is None or not runtime.news.lives:
            raise SiteRefusal(Reason.of("site.does_not_run", name=name))
        others = sorted({_user(session.name) for session in runtime.news.sessions} - {guest.name})
        holders = [holder for holder in _holders(runtime.news).values() if holder != guest.name]
        if guest.role < Role.OWNER and (others or holders):
            users = tuple(dict.fromkeys((*holders, *others)))
            raise SiteRefusal(Reason.of("site.others_there", name=name, users=users))
        runtime.end(Reason.of("site.ended_by", user=guest.name))
        runtime.join(_END_S)

    def close(self) -> None:
        """The site ends, and all its runtimes with it."""
        with self._lock:
            self._is_over = True
            runtimes = list(self._runtimes.values())
        for runtime in runtimes:
            runtime.end(Reason.of("site.ends", site=self._site))
        for runtime in runtimes:
            runtime.join(_END_S)

    # Inner

    def _of(self, name: str) -> Launch:
        launch = self._launches.get(name)
        if launch is None:
            names = tuple(self._launches)
            raise SiteRefusal(Reason.of("site.not_listed", name=name, site=self._site, names=names), 404)
        return launch

    def _judge(self, launch: Launch, guest: Guest) -> None:
        """Whether this guest may launch it now."""
        if guest.role < Role.OPERATOR:
            raise SiteRefusal(Reason.of("site.role_wanted", role=guest.role.word, user=guest.name), 403)
        runtime = self._runtimes.get(launch.name)
        if not launch.robot or (runtime is not None and runtime.news.lives):
            return
        slots = Slots(self._bookings.of(launch.robot))
        wrong = slots.refusal(guest.name, self._bookings.now_s(), is_needed=launch.needs_booking)
        if wrong:
            raise SiteRefusal(Reason.of("site.not_launched", name=launch.name, why=wrong))

    def _card_of(self, launch: Launch) -> LaunchCard:
        runtime = self._runtimes.get(launch.name)
        news = RuntimeNews("off") if runtime is None else runtime.news
        standing = news.standing if news.lives else None
        subsystems = () if standing is None else standing.subsystems
        return LaunchCard(
            name=launch.name,
            state="off" if news.state == "over" else news.state,
            reason=news.reason,
            worlds=launch.worlds,
            robot=launch.robot,
            is_virtual=launch.is_virtual,
            stays=launch.stays if runtime is None else runtime.stays,
            port=news.port if news.lives else 0,
            holders=_holders(news),
            users=tuple(sorted({_user(session.name) for session in news.sessions})) if news.lives else (),
            runs=tuple(dict.fromkeys(subsystem.application for subsystem in subsystems if subsystem.application)),
            is_stopped=standing is not None and standing.is_stopped,
            bookings=tuple(self._bookings.of(launch.robot)) if launch.robot else (),
        )


def _holders(news: RuntimeNews) -> dict[str, str]:
    """The users who hold something, by subsystem."""
    if news.standing is None or not news.lives:
        return {}
    return {subsystem.name: _user(subsystem.holder) for subsystem in news.standing.subsystems if subsystem.holder}


def _user(session: str) -> str:
    return session.partition("#")[0]
