"""A simulated network: environments, one runtime, seeded faults between them, virtual time, the same every time.

A history is a storm (loss, duplication, reordering, cuts of one connection or all, one-way cuts, good-byes, crashes of
every program, all from one seed) and then a calm in which everything that was promised has to come true. A `LinkOracle`
watches. Each environment has one connection for everything or one for each channel, as it likes.
"""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from kit.link.event_scheduler import EventScheduler
from kit.link.link_oracle import LinkOracle, Wanted, Who
from kit.link.net_faults import FaultyNet, NetFaults
from kit.link.sim_link import SimCarrier, SimLink
from kit.link.sim_programs import HONEST, Programs, SimEnvironment, SimProgram, SimRuntime
from onika.link.caller import Caller, Role
from onika.link.channel import THREE, Channel
from onika.link.link_events import RequestReceived
from onika.link.link_terms import LinkTerms
from onika.link.session import EnvironmentSession
from onika.link.session_channels import SessionChannels
from onika.link.sessions import Introduction
from onika.wire.packet import Bye, Hello, Packet, encode
from onika.words.reason import Reason

_MS = 1_000_000
_STORM_NS = 4_000 * _MS
_CALM_NS = 6_000 * _MS
_ENOUGH = 3
"""Looks, a quarter of a second apart, that have to find everything made good before a history ends."""
_SLACK_NS = 60 * _MS


@dataclass(frozen=True, slots=True)
class Report:
    """What a history came to; equal for equal seeds and programs."""

    seed: int
    faults: tuple[str, ...]
    signals: int
    requests: int
    events: int
    digest: str


class NetworkHistory:
    """One history, from a seed."""

    def __init__(self, seed: int, programs: Programs = HONEST) -> None:
        self._seed = seed
        self._time = EventScheduler(seed)
        self._weather = NetFaults.draw(self._time.random)
        self._sky = FaultyNet(self._weather, self._time)
        self._programs = programs
        self._terms = LinkTerms(
            beat_ns=400 * _MS,
            suspect_ns=900 * _MS,
            lost_ns=1_600 * _MS,
            greeting_ns=1_500 * _MS,
            retry_ns=0 if self._weather.is_reliable else 250 * _MS,
            window=8,
            piece=64,
            body_limit=10_000,
        )
        self._digest = hashlib.blake2b(digest_size=16)
        self._witness = LinkOracle()
        self._lives = 0
        self._labels = 0
        self._names = 0
        self._settled = 0
        self._is_over = False
        self._house = self._start_house()
        number = self._time.random.choice((1, 1, 1, 2, 2, 3))
        self._environments = [self._start_environment(n, "") for n in range(number)]

    def run(self) -> Report:
        """Live through it; stops at the first fault."""
        self._plan()
        end_ns = _STORM_NS + _CALM_NS
        while not (self._is_over or self._witness.faults) and self._time.step(end_ns):
            pass
        if not self._witness.faults:
            self._final()
        return Report(
            self._seed,
            tuple(self._witness.faults),
            self._witness.accepted,
            self._witness.begun,
            self._time.count,
            self._digest.hexdigest(),
        )

    @property
    def now_ns(self) -> int:
        """True time."""
        return self._time.now_ns

    def _final(self) -> None:
        for environment in self._environments:
            self._witness.final(
                environment.name, environment.session_channels.epoch, environment.session_channels.state
            )
        self._witness.final_requests()

    def _is_settled(self) -> bool:
        """Whether all has come true already."""
        faults, self._witness.faults = self._witness.faults, []
        self._final()
        is_settled, self._witness.faults = not self._witness.faults, faults
        return is_settled

    # -- the programs

    def _start_environment(self, number: int, name: str) -> SimEnvironment:
        self._names += 1
        name = name or f"client-{self._names}"
        channels = (Channel.ALL,) if self._time.random.random() < 0.4 else THREE
        session_channels = self._programs.session_channels(
            name, self._terms, channels, self._programs.client, self._time.random.random
        )
        self._witness.environment_starts(name)
        environment = SimEnvironment(number, name, session_channels, self._time.random.randrange(10**15))
        self._time.after(self._time.uniform(0, 300), partial(self._serve, environment))
        return environment

    def _start_house(self) -> SimRuntime:
        self._lives += 1
        sessions = self._programs.sessions(self._programs.epoch(self._lives), self._terms, make=self._programs.server)
        return SimRuntime(sessions, self._time.random.randrange(10**15))

    def _signal(self) -> None:
        if not self._house.is_up:
            return
        clock = self._clock(self._house)
        for session in self._house.sessions.sessions:
            body = f"{session.epoch} {self._time.random.random()}".encode()
            self._witness.signal(session.epoch, body)
            session.signal(body, clock)
            session.show(f"key-{self._time.random.randrange(3)}", b"%d" % (self.now_ns + 1), clock)
            self._serve_session(session)

    def _ask(self) -> None:
        environment = self._time.random.choice(self._environments)
        self._labels += 1
        body = f"{self._labels} ".encode() + b"x" * self._time.random.choice((0, 10, 200))
        within_ns = self._time.random.choice((0, 100, 1_000)) * _MS
        once = self._time.random.random() < 0.3
        asking = environment.plugs.get(Channel.SESSION) or environment.plugs.get(Channel.ALL)
        begin_by_ns = self.now_ns + within_ns if within_ns else 0
        wanted = Wanted(str(self._labels), environment.name, body, once, begin_by_ns, asking.cable if asking else None)
        urgent = self._time.random.random() < 0.1
        # the witness has to know of it before the answer can come
        self._witness.wants(wanted, environment.session_channels.request_count + 1)
        environment.session_channels.request(body, self._clock(environment), within_ns, once, urgent)
        self._serve(environment)

    def _answer(self, house: SimRuntime, session: EnvironmentSession, arrival: RequestReceived) -> None:
        if house is self._house:
            session.reply(arrival.ticket, b"re: " + arrival.body, self._clock(house))
            self._serve_session(session)

    def _crash_environment(self) -> None:
        environment = self._time.random.choice(self._environments)
        if self._time.random.random() < 0.3:
            environment.session_channels.close(Reason.plain("enough"), self._clock(environment))
            self._witness.leaves(environment.name)
        environment.is_up = False
        for plug in list(environment.plugs.values()):
            plug.close()
        self._witness.environment_ends(environment.name)
        name = environment.name if self._time.random.random() < 0.3 else ""
        if name:
            self._witness.comes_anew(name)
        self._environments[environment.number] = self._start_environment(environment.number, name)

    def _crash_house(self) -> None:
        if self._house.is_up:
            self._house.is_up = False
            for plug in list(self._house.plugs.values()):
                plug.close()
            self._witness.house_ends()
            self._time.after(self._time.uniform(50, 1_500), self._boot)

    def _boot(self) -> None:
        self._house = self._start_house()

    # -- serving a program: what it says, what it tells, when it wants to be ticked

    def _clock(self, party: SimProgram) -> int:
        return self.now_ns + party.clock_ns

    def _serve(self, environment: SimEnvironment, channel: Channel | None = None) -> None:
        if not environment.is_up:
            return
        environment.session_channels.service(self._clock(environment), channel)
        asking = environment.plugs.get(Channel.SESSION) or environment.plugs.get(Channel.ALL)
        stream = environment.plugs.get(Channel.STREAM) or asking
        for notice in environment.session_channels.take_notices():
            self._witness.heard(
                environment.name, notice, asking.cable if asking else None, stream.cable if stream else None
            )
        for wanted in environment.session_channels.wants(self._clock(environment)):
            self._time.after(self._time.uniform(1, 30), partial(self._dial, environment, wanted))
        self._time.wake(
            environment,
            environment.session_channels.due_ns(self._clock(environment)),
            partial(self._serve, environment),
        )

    def _serve_session(self, session: EnvironmentSession, cable: SimLink | None = None) -> None:
        house = self._house
        if not house.is_up or session not in house.sessions.sessions:
            return
        for notice in session.service(self._clock(house), cable.channel if cable is not None else None):
            self._witness.served(session.name, notice, cable, self.now_ns)
            if isinstance(notice, RequestReceived):
                self._time.after(self._time.uniform(0, 800), partial(self._answer, house, session, notice))
        self._time.wake(session, session.due_ns(self._clock(house)), partial(self._serve_session, session))

    def _look_for_lost(self) -> None:
        for name in self._house.sessions.lost(self._clock(self._house)):
            self._witness.given_up(name, self.now_ns, self._terms.lost_ns)

    def _inspect(self) -> None:
        suspect_ns, lost_ns = self._terms.suspect_ns, self._terms.lost_ns
        for environment in self._environments:
            for channel, state in environment.session_channels.states().items():
                if channel in environment.plugs:
                    silence_ns = self.now_ns - environment.plugs[channel].heard_ns - _SLACK_NS
                    self._witness.heard_last(Who.ENVIRONMENT, state, silence_ns, suspect_ns, lost_ns)
        if not self._house.is_up:
            return
        for session in self._house.sessions.sessions:
            for channel, state in session.states().items():
                plug = self._house.plugs.get((session, channel))
                if plug is not None:
                    silence_ns = self.now_ns - plug.heard_ns - _SLACK_NS
                    self._witness.heard_last(Who.RUNTIME, state, silence_ns, suspect_ns, lost_ns)
        self._settled = self._settled + 1 if self._sky.is_calm and self._is_settled() else 0
        self._is_over = self._settled == _ENOUGH
        self._look_for_lost()
        self._witness.stands(self.now_ns - _SLACK_NS, lost_ns)

    # -- the network between them

    def _dial(self, environment: SimEnvironment, channel: Channel) -> None:
        if not environment.is_up:
            return
        if max(environment.blind_ns, environment.deaf_ns) > self.now_ns or not self._house.is_up:
            environment.session_channels.failed(channel, self._clock(environment))
        else:
            plug = SimLink(self, channel, environment.name).environment
            plug.heard_ns = self.now_ns
            environment.plugs[channel] = plug
            environment.session_channels.attach(channel, plug, self._clock(environment))
        self._serve(environment)

    def sent(self, plug: SimCarrier, packet: Packet) -> None:
        """A packet left an end."""
        self._witness.sent(Who.RUNTIME if plug.is_runtime else Who.ENVIRONMENT, plug.cable, packet)

    def carry(self, plug: SimCarrier, act: Callable[[], None]) -> None:
        """Let it arrive, as the weather wants it."""
        self._sky.carry(plug, self._blind_until(plug), act)

    def tell_end(self, plug: SimCarrier, act: Callable[[], None]) -> None:
        """Let the other end learn of it, as the weather wants it."""
        self._sky.tell_end(plug, self._blind_until(plug), act)

    def _blind_until(self, plug: SimCarrier) -> int:
        environment = self._environments_of(plug)
        return environment.deaf_ns if plug.is_runtime else environment.blind_ns

    def came(self, plug: SimCarrier, packet: Packet, payload: bytes) -> None:
        """A packet lies in the inbox of an end."""
        self._digest.update(b"%d %d " % (self.now_ns, plug.is_runtime) + payload)
        if not plug.is_runtime:
            self._serve(self._environments_of(plug), plug.cable.channel)
            return
        session = self._session_at(plug)
        if session is None and self._house.is_up and isinstance(packet, Hello):
            session = self._admit(plug, packet)
        if session is not None:
            if plug.cable.channel.asks:
                self._witness.called(session.name, self.now_ns)
            self._serve_session(session, plug.cable)

    def ended(self, plug: SimCarrier) -> None:
        """An end learns that its connection is no more."""
        if not plug.is_runtime:
            self._serve(self._environments_of(plug))
        elif (session := self._session_at(plug)) is not None:
            self._serve_session(session, plug.cable)

    def _admit(self, plug: SimCarrier, hello: Hello) -> EnvironmentSession | None:
        """What the porter and the gate do."""
        sessions = self._house.sessions
        caller = Caller("somebody", Role.OWNER, "elsewhere", False)
        cable = plug.cable
        why = sessions.admit(
            Introduction(cable.channel, hello.client, hello.epoch, caller), plug, self._clock(self._house)
        )
        if why:
            plug.send(encode(Bye("refused", why)))
            plug.close()
            return None
        session = next(session for session in sessions.sessions if session.client == hello.client)
        self._witness.session(session.name, session.epoch, hello.client)
        self._house.plugs[session, cable.channel] = plug
        return session

    def _session_at(self, plug: SimCarrier) -> EnvironmentSession | None:
        if not self._house.is_up:
            return None
        return next((environment for (environment, _), other in self._house.plugs.items() if other is plug), None)

    def _environments_of(self, plug: SimCarrier) -> SimEnvironment:
        """The environment at this cable's other end; one that is no more cannot be found, and hears nothing."""
        for environment in self._environments:
            if plug.cable.environment in environment.plugs.values():
                return environment
        return self._gone

    @property
    def _gone(self) -> SimEnvironment:
        nobody = SimEnvironment(-1, "", SessionChannels("nobody"), 0)
        nobody.is_up = False
        return nobody

    def _cut(self) -> None:
        """Nothing more arrives on one connection, or on all of an environment's; each side learns it later."""
        environment = self._time.random.choice(self._environments)
        plugs = list(environment.plugs.values())
        for plug in plugs if self._time.random.random() < 0.5 else plugs[:1]:
            plug.cable.is_broken = True
            self._time.after(self._time.uniform(0, 600), plug.hear_end)
            self._time.after(self._time.uniform(0, 600), plug.peer.hear_end)

    def _blind(self) -> None:
        environment = self._time.random.choice(self._environments)
        until_ns = self.now_ns + self._time.uniform(100, 3_000)
        both = self._time.random.random() < 0.3
        if both or self._time.random.random() < 0.5:
            environment.blind_ns = until_ns
        if both or environment.blind_ns < until_ns:
            environment.deaf_ns = until_ns

    def _heal(self) -> None:
        self._sky.is_calm = True
        for environment in self._environments:
            environment.blind_ns = min(environment.blind_ns, self.now_ns)
            environment.deaf_ns = min(environment.deaf_ns, self.now_ns)

    # -- the plan of the storm

    def _plan(self) -> None:
        random = self._time.random
        for _ in range(random.randrange(40, 80)):
            self._time.at(random.randrange(_STORM_NS), self._signal)
        for _ in range(random.randrange(20, 50)):
            self._time.at(random.randrange(_STORM_NS), self._ask)
        troubles = (self._cut, self._blind, self._crash_environment, self._crash_house)
        for trouble in random.choices(troubles, weights=(5, 6, 2, 1), k=random.randrange(7)):
            self._time.at(random.randrange(_STORM_NS), trouble)
        self._time.at(_STORM_NS, self._heal)
        for at_ns in range(0, _STORM_NS + _CALM_NS, 250 * _MS):
            self._time.at(at_ns, self._inspect)
