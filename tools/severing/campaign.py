"""A campaign: runs of three sites one after the other, with one blow each, and what came of it."""

import os
import secrets
import signal
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from random import Random
from time import monotonic, monotonic_ns

from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.link.lost import LinkLost
from onika.wire import live, request, steer
from onika.wire.plan import Do, Halt, Meet, Plan
from onika.wire.rendezvous_link import (
    Linked,
    LinkedRuntime,
    LinkRuntimes,
    MeetingTerms,
    OfferPact,
    PactOffered,
    SharedTag,
)
from onika.words.reason import Reason
from severing.far_site import FarSite
from severing.trails import joined, segments, skews, trail

SITES, STEPS, CYCLES, RATE = 3, 4, 60, 100.0
HOME = SITES
"""Where whoever joins them is."""
SLACK_NS = 30_000_000
"""Of the bound: a cycle and a half, and what a crowded machine adds."""
STOPPED_S = 1.5
STEP = """
import os
from time import monotonic_ns

from onika.module import Input, Module, finish

class Step(Module):
    trigger = True
    number = Input("int", "-", "which step", low=0, high=1000)
    count = Input("int", "-", "how many cycles", low=1, high=1000)

    def init(self):
        self._file = os.open("PATH", os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)

    def _note(self, what):
        os.write(self._file, f"{what} {self._number} {monotonic_ns()}\\n".encode())

    def on(self, inputs):
        self._number, self._left, self._is_first = inputs.number, inputs.count, True

    def cycle(self):
        self._note("begin" if self._is_first else "cycle")
        self._is_first = False
        self._left -= 1
        if self._left <= 0:
            self._note("done")
            return finish()
        return None
"""


def plan(site: int, path: Path) -> Plan:
    """One flow with a tag before each of its steps."""
    shop = PlanBuilder()
    shop.task("step", STEP.replace("PATH", str(path)), frequency=RATE)
    whole = shop.plan([action("step", arguments=f"{number} {CYCLES}") for number in range(STEPS)])
    program = [instruction for number in range(STEPS) for instruction in (Meet("x"), Do(number))]
    return replace(whole, flows=(replace(whole.flows[0], subsystem=f"flow{site}", program=(*program, Halt())),))


class Campaign:
    """Runs one after the other, with one blow each."""

    def __init__(self, folder: Path, token: str, hosts: Sequence[str], seed: int) -> None:
        self.folder, self.random = folder, Random(seed)
        self.sites = [FarSite(number, host, token, folder) for number, host in enumerate(hosts)]
        self.alone_ns = self.run = 0
        self.is_loud = False
        self.longest_ns, self.lone, self.kinds, self.skews_us = 0, 0, dict[str, int](), list[float]()
        self.faults: list[str] = []

    def paths(self) -> list[Path]:
        """Where flows of the present run write down what they do."""
        return [self.folder / f"flow{site}-{self.run}" for site in range(SITES)]

    def strike(self, kind: str) -> None:
        """One run with one blow, and what came of it."""
        self.run += 1
        self.kinds[kind] = self.kinds.get(kind, 0) + 1
        began_s = monotonic()
        self.begin()
        ready_s = monotonic()
        self.listen(self.random.uniform(0.2, 4.0))
        struck, expects_all = self.blow(kind)
        struck_s = monotonic()
        is_whole = self.finish() if expects_all else self.end(self.sites[struck] if kind == "kill" else None)
        if self.is_loud:
            print(
                f"run {self.run}: {kind}; joined and begun in {ready_s - began_s:.1f} s, struck after "
                f"{struck_s - ready_s:.1f} s, over {monotonic() - struck_s:.1f} s later", flush=True,
            )  # fmt: skip
        self.judge(kind, struck, is_whole=is_whole, expects_all=expects_all)

    def begin(self) -> None:
        """Prepare on all, join them, begin."""
        paths, pacts = self.paths(), dict[int, request.Response]()

        def prepare(site: FarSite) -> None:
            site.results.clear()
            prepared = site.join().ask(request.Prepare(plan(site.number, paths[site.number]), ()))
            assert isinstance(prepared, request.Prepared), prepared
            assert not prepared.faults, prepared.faults
            pacts[site.number] = site.join().ask(OfferPact(site.host))

        self.at_once(prepare)
        partners = []
        for site in self.sites:
            pact = pacts[site.number]
            assert isinstance(pact, PactOffered), pact
            there = site.host, pact.port, pact.name, pact.key, pact.epoch
            partners.append(LinkedRuntime(site.number, f"site{site.number}", *there))
        run, tags = secrets.token_bytes(16), (SharedTag("x", tuple(range(SITES))),)
        answers: dict[int, request.Response] = {}

        def link(site: FarSite) -> None:
            others = tuple(partner for partner in partners if partner.site != site.number)
            answers[site.number] = site.join().ask(LinkRuntimes(run, site.number, others, tags))

        self.at_once(link)
        ways = []
        for answer in answers.values():
            assert isinstance(answer, Linked), answer
            assert not answer.refusal, answer.refusal
            ways += answer.ways
        terms = MeetingTerms(max(w.trip_ns for w in ways) // 2, max(w.clock_ns for w in ways) * 5 // 4 + 1_000_000)
        self.alone_ns = RendezvousTerms(terms.one_way_ns, terms.clock_ns).alone_ns
        begin = request.Begin(meets=terms, on_error="wait", settle_s=0.0)
        self.at_once(lambda site: site.join().ask(begin))

    def at_once(self, do: Callable[[FarSite], object]) -> None:
        """For all sites at a time; whoever is ready first is not silent meanwhile."""
        left, faults = set(range(SITES)), list[BaseException]()

        def carry(site: FarSite) -> None:
            try:
                do(site)
            except BaseException as fault:
                faults.append(fault)
            left.discard(site.number)
            while left:
                site.listen(0.05)

        threads = [threading.Thread(target=carry, args=(site,)) for site in self.sites]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        if faults:
            raise faults[0]

    def listen(self, seconds: float) -> None:
        """Hear all of them for so long."""
        self.at_once(lambda site: site.listen(seconds))

    def blow(self, kind: str) -> tuple[int, bool]:
        """Deal it: when (ns), and whether all flows can be completed after it."""
        one = self.random.randrange(SITES)
        other = (one + self.random.randrange(1, SITES)) % SITES
        at_ns = monotonic_ns()
        match kind:
            case "cut" | "one way":
                tell(f"cut {one} {other} {int(kind == 'cut')}")
                self.listen(self.random.choice((0.05, 0.2, 0.6, 2.0)))
            case "alone":  # also from whoever joined them: once he was silent for too long, its flow ends
                for site in range(SITES + 1):
                    tell(f"cut {one} {site} 1" if site != one else "")
                self.listen(self.random.choice((0.2, 1.0, 3.0)))
                tell("mend")
                return at_ns, False
            case "freeze":
                pid = self.sites[one].pid()
                os.kill(pid, signal.SIGSTOP)
                self.listen(self.random.choice((0.05, 0.2)))
                os.kill(pid, signal.SIGCONT)
            case "kill":
                os.kill(self.sites[one].pid(), signal.SIGKILL)
                return one, False
            case "stop":
                for site in range(SITES):  # nobody but one site hears who says it; the others have it from there
                    tell(f"cut {HOME} {site} 1" if site != one else "")
                self.listen(0.1)
                at_ns = monotonic_ns()
                with suppress(LinkLost, TimeoutError):
                    self.sites[one].join().ask(request.Stop(Reason.plain("enough")))
                self.listen(STOPPED_S + 0.5)
                tell("mend")
                return at_ns, False
        tell("mend")
        return at_ns, True

    def finish(self) -> bool:
        """Clear what was held until every run is over; whether all were completed."""
        until = monotonic() + 40.0
        while not all(site.results for site in self.sites) and monotonic() < until:
            self.listen(0.3)
            for site in self.sites:
                if not site.results:
                    with suppress(LinkLost, TimeoutError):
                        site.join().ask(steer.Recover(f"flow{site.number}"))
        return all(site.results and site.results[0].completed for site in self.sites)

    def end(self, dead: FarSite | None) -> bool:
        """What is left of a run in which a site is no more, or everything was stopped, ends.

        The dead one is asked nothing: an answer is waited for as long as a line may be cut, which is a minute.
        """
        self.listen(1.5)
        for site in [site for site in self.sites if site is not dead]:
            with suppress(LinkLost, OSError, TimeoutError):
                site.join().ask(request.Abort(Reason.plain("enough")))
                site.join().ask(live.Reset())
        for site in self.sites:
            site.leave()
        return True

    def judge(self, kind: str, struck: int, *, is_whole: bool, expects_all: bool) -> None:
        """Hold what flows wrote against what is promised."""
        trails = [trail(path) for path in self.paths()]
        for number, own in enumerate(trails):
            others = [other for site, other in enumerate(trails) if site != number]
            killed = not expects_all and kind == "kill" and number == struck
            for step, begin_ns, last_ns in segments(own):
                alone_ns = min(last_ns, max(joined(other, step, begin_ns) for other in others)) - begin_ns
                self.lone += alone_ns > SLACK_NS
                self.longest_ns = max(self.longest_ns, alone_ns)
                if alone_ns > self.alone_ns + SLACK_NS and not killed:
                    self.fault(kind, f"flow{number} was alone in step {step} for {alone_ns / 1e6:.0f} ms")
            done = [step for what, step, _ in own if what == "done"]
            if expects_all and sorted(set(done)) != list(range(STEPS)):
                self.fault(kind, f"flow{number} did {done}")
            if kind == "stop":
                late = [at_ns for what, _, at_ns in own if what != "done" and at_ns > struck + STOPPED_S * 1e9]
                if late:
                    self.fault(kind, f"flow{number} went on {(late[-1] - struck) / 1e9:.1f} s after Stop")
        if expects_all and not is_whole:
            self.fault(kind, "not all were completed")
        self.skews_us += skews(trails)

    def fault(self, kind: str, says: str) -> None:
        """A promise that was broken."""
        self.faults.append(says)
        print(f"run {self.run}, {kind}: {says}", flush=True)


def tell(what: str) -> None:
    """Have whoever carries the lines do something."""
    if what:
        print(f"@{what}", flush=True)
