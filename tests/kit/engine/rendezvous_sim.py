"""Simulated runtimes whose flows meet at a tag: the real protocol, seeded faults, virtual time, the same every time.

A history is a storm (loss, lateness, cuts, frozen programs and machines, crashes, clocks that are apart and drift,
users who let flows pass) and then a calm, in which everybody has to come to the end. A `RendezvousOracle` watches.
"""

from functools import partial

from kit.engine.rendezvous_net import MS, STORM_NS, RendezvousNet
from kit.engine.rendezvous_oracle import RendezvousOracle
from kit.engine.rendezvous_runtime import HONEST, Parts, SimRuntime, Stranger
from kit.link.event_scheduler import EventScheduler
from onika.engine.rendezvous_terms import RendezvousTerms

_END_NS = STORM_NS + 30_000 * MS


class RendezvousHistory:
    """One history, from a seed; `clock_ns` is by how much the terms say that clocks may be misjudged."""

    def __init__(self, seed: int, one_way_ns: int = MS // 2, sites: int = 2, parts: Parts = HONEST) -> None:
        self.time = EventScheduler(seed)
        random = self.time.random
        self.terms = RendezvousTerms(one_way_ns, one_way_ns * 5 // 4 + MS)
        self.net = RendezvousNet(self.time, one_way_ns)
        self.oracle = RendezvousOracle(range(sites), self.terms)
        epochs = {site: random.getrandbits(60) for site in range(sites)}
        self.runtimes = [SimRuntime(self, site, epochs, parts) for site in range(sites)]
        self.has_crash = random.random() < 0.15
        for runtime in self.runtimes:
            self.time.after(self.time.uniform(0, 20), runtime.speak)
            self.time.after(self.time.uniform(50, 1_000), runtime.come)
        self._plan_faults(parts)

    @property
    def now_ns(self) -> int:
        """True time."""
        return self.time.now_ns

    def run(self) -> RendezvousOracle:
        """Live through it."""
        while not all(runtime.is_done or runtime.is_gone for runtime in self.runtimes):
            if not self.time.step(_END_NS) or self.oracle.faults:
                break
        late = [runtime.site for runtime in self.runtimes if not (runtime.is_done or self.has_crash)]
        self.oracle.final(self.now_ns, late)
        return self.oracle

    def _plan_faults(self, parts: Parts) -> None:
        random = self.time.random
        for runtime in self.runtimes:
            for freeze in (self._freeze_program, self._freeze_machine):
                if random.random() < 0.5:
                    lasts_ns = random.choice((30, 200, 1_000)) * MS
                    self.time.after(random.randrange(STORM_NS), partial(freeze, runtime, lasts_ns))
        if random.random() < 0.1:
            self.time.after(random.randrange(STORM_NS), random.choice(self.runtimes).let_pass)
        if self.has_crash:
            self.time.after(random.randrange(STORM_NS), partial(self._crash, random.choice(self.runtimes), parts))

    def _freeze_program(self, runtime: SimRuntime, lasts_ns: int) -> None:
        runtime.frozen_ns = max(runtime.frozen_ns, self.now_ns + lasts_ns)

    def _freeze_machine(self, runtime: SimRuntime, lasts_ns: int) -> None:
        """Everything but the drives, which hold by themselves where the executive would have."""
        self._freeze_program(runtime, lasts_ns)
        runtime.machine_frozen_ns = self.now_ns + lasts_ns

    def _crash(self, runtime: SimRuntime, parts: Parts) -> None:
        """It comes back at once with another epoch, and says that its flows wait at the tag; the run is another one."""
        self.oracle.crashes(runtime.site, self.now_ns)
        runtime.is_gone = True
        stranger = Stranger(self, runtime.site, {**runtime.epochs, runtime.site: 1}, parts)
        self.runtimes[runtime.site] = stranger
        stranger.start(runtime.visit + 1)
