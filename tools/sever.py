"""Three sites far apart carry out one application together, while lines are cut and runtimes killed at random.

    PYTHONPATH=tests python tools/sever.py --seed 7 --blows 40

Each site is a network namespace in which `onika site serve` runs, as guide 38 sets it up; who launches the runtimes and
joins them is in a namespace of its own, so lines to him are cut as well. Every flow has a tag before each step. What
each flow did is written down by its own module, with the machine's clock, and judged afterwards: nobody was driven on
alone for longer than the stated bound, nobody passed a tag alone, every step was done, a Stop reached everybody to whom
a way was open. It needs root, and ends with 1 where a promise was broken.
"""

import argparse
import os
import secrets
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from random import Random
from time import monotonic, monotonic_ns, sleep

from msgspec.structs import replace

from far_line import FarLine
from kit.plans.plan_builder import PlanBuilder, action
from onika.desk.run.remote_runtime import RemoteRuntime
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.link.lost import LinkLost
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_client import SiteClient
from onika.link.websocket_opening import WebSocketOpening
from onika.wire import event, live, request, steer
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

SITES, STEPS, CYCLES, RATE = 3, 4, 60, 100.0
HOME = SITES
"""Where whoever joins them is."""
SLACK_NS = 30_000_000
"""Of the bound: a cycle and a half, and what a crowded machine adds."""
STOPPED_S = 1.5
LIST = "VERSION 2.0\n\nLAUNCH arm\nPORT 7996\nCODE yes\n\nEOF\n"
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


class Site:
    """One site: its service, and the runtime that it launches for us."""

    def __init__(self, number: int, host: str, token: str, folder: Path) -> None:
        self.number, self.host = number, host
        self._address = SiteAddress.parse(f"site://{host}/arm?stay")
        self._token, self._authority = token, folder / "tls.crt"
        self.session: RemoteRuntime | None = None
        self.results: list[event.Result] = []

    def listen(self, seconds: float) -> None:
        """Hear it for so long, and let it hear us; one that is gone is silent."""
        until = monotonic() + seconds
        while monotonic() < until:
            with suppress(LinkLost, TimeoutError):
                if self.session is not None:
                    self.results += [m for m in self.session.events(0.02) if isinstance(m, event.Result)]
                    continue
            sleep(0.02)

    def join(self) -> RemoteRuntime:
        """Have it run, and a session with it."""
        for again in (True, True, False):
            try:
                self.session = self.session or self._joined()
                return self.session
            except LinkLost as lost:  # as a person would, who is told why, try again
                print(f"    site{self.number}: {lost}", flush=True)
                if not again:
                    raise
        raise AssertionError

    def _joined(self) -> RemoteRuntime:
        handed = SiteClient(self._address, self._token, self._authority).launch()
        opening = WebSocketOpening(self._address.runtime(handed.port), self._token, self._authority)
        return RemoteRuntime(opening).__enter__()

    def leave(self) -> None:
        """It is gone, or to be begun anew."""
        if self.session is not None:
            with suppress(LinkLost, OSError, TimeoutError):
                self.session.__exit__(None, None, None)
        self.session = None

    def pid(self) -> int:
        """The process of the runtime's program."""
        wanted = [b"onika.host", f"{self.host}:7996".encode()]
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            with suppress(OSError):
                words = path.read_bytes().split(b"\0")
                if all(word in words for word in wanted) and b"--link-fd" in words:
                    return int(path.parent.name)
        return 0


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
        self.sites = [Site(number, host, token, folder) for number, host in enumerate(hosts)]
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
        if self.is_loud:
            print(f"run {self.run}: {kind}", flush=True)
        self.begin()
        self.listen(self.random.uniform(0.2, 4.0))
        struck, expects_all = self.blow(kind)
        is_whole = self.finish() if expects_all else self.end()
        self.judge(kind, struck, is_whole=is_whole, expects_all=expects_all)

    def begin(self) -> None:
        """Prepare on all, join them, begin."""
        paths, pacts = self.paths(), dict[int, request.Response]()

        def prepare(site: Site) -> None:
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

        def link(site: Site) -> None:
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

    def at_once(self, do: Callable[[Site], object]) -> None:
        """For all sites at a time; whoever is ready first is not silent meanwhile."""
        left, faults = set(range(SITES)), list[BaseException]()

        def carry(site: Site) -> None:
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

    def end(self) -> bool:
        """What is left of a run in which a site is no more, or everything was stopped, ends."""
        self.listen(1.5)
        for site in self.sites:
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


Trail = list[tuple[str, int, int]]


def trail(path: Path) -> Trail:
    """What a flow wrote: what, of which step, when in ns."""
    lines = path.read_text().splitlines() if path.exists() else []
    rows = (line.split() for line in lines if line.count(" ") == 2)
    return [(what, int(step), int(at_ns)) for what, step, at_ns in rows]


def segments(own: Trail) -> list[tuple[int, int, int]]:
    """Each time that a step was gone through: the step, its first cycle and its last one, in ns."""
    found: list[tuple[int, int, int]] = []
    for what, step, at_ns in own:
        if what == "begin":
            found.append((step, at_ns, at_ns))
        elif found and found[-1][0] == step:
            found[-1] = step, found[-1][1], at_ns
    return found


def joined(other: Trail, step: int, begin_ns: int) -> int:
    """From when on another flow is in this step with somebody who began it then, or has done it; else never."""
    times = [at_ns for what, number, at_ns in other if number == step and what == "done"]
    times += [at_ns for what, number, at_ns in other if number == step and what == "begin" and at_ns > begin_ns - 10**8]
    times += [at_ns for what, number, at_ns in other if number > step]
    return max(begin_ns, min(times, default=2**63))


def skews(trails: Sequence[Trail]) -> list[float]:
    """How far apart first cycles of a step are that all have begun together, in us."""
    found = []
    for step, begin_ns, _ in segments(trails[0]):
        near = [
            [at for number, at, _ in segments(other) if number == step and abs(at - begin_ns) < 50_000_000]
            for other in trails[1:]
        ]
        if all(near):
            times = [begin_ns, *(at[0] for at in near)]
            found.append((max(times) - min(times)) / 1e3)
    return found


def tell(what: str) -> None:
    """Have whoever carries the lines do something."""
    if what:
        print(f"@{what}", flush=True)


KINDS = ("cut", "cut", "one way", "one way", "alone", "freeze", "kill", "stop")


def campaign(folder: Path, token: str, seed: int, blows: int, hosts: Sequence[str]) -> int:
    """From within the namespace of whoever joins them."""
    running = Campaign(folder, token, hosts, seed)
    running.is_loud = True
    for _ in range(blows):
        running.strike(running.random.choice(KINDS))
        print(
            f"    {running.lone} alone, {running.longest_ns / 1e6:.0f} of {running.alone_ns / 1e6:.0f} ms", flush=True
        )
    for site in running.sites:
        site.leave()
    skew = sorted(running.skews_us) or [0.0]
    middle, last = skew[len(skew) // 2], skew[int(0.99 * (len(skew) - 1))]
    print(f"{blows} blows {running.kinds}: {running.lone} begun alone, the longest {running.longest_ns / 1e6:.0f} ms, "
          f"stated {running.alone_ns / 1e6:.0f} ms; {len(skew)} begun together, apart p50 {middle / 1e3:.2f}, "
          f"p99 {last / 1e3:.2f}, most {skew[-1] / 1e3:.2f} ms; {len(running.faults)} promises broken")  # fmt: skip
    return int(bool(running.faults))


def serve(line: FarLine, folder: Path, token: str, given: argparse.Namespace) -> int:
    """Begin the services of the sites and the campaign, and cut lines as it says."""
    hosts = [line.address(site) for site in range(SITES)]
    onika = str(Path(sys.executable).with_name("onika"))
    services = []
    for site, host in enumerate(hosts):
        words = [onika, "site", "serve", str(folder / "list"), "--name", f"site{site}", "--listen", f"{host}:7995"]
        words += ["--users", str(folder / "users"), "--cert", f"{folder}/tls.crt", "--key", f"{folder}/tls.key"]
        state = os.environ | {"XDG_STATE_HOME": str(folder / f"state{site}")}
        with (folder / f"site{site}.log").open("wb") as log:
            service = subprocess.Popen(
                line.within(site, [*words, "--no-black-box"]), env=state, stdout=subprocess.PIPE, stderr=log
            )
        assert service.stdout is not None
        if not service.stdout.readline():
            raise SystemExit((folder / f"site{site}.log").read_text())
        services.append(service)
    words = [sys.executable, __file__, "--within", str(folder), token, *hosts]
    words += ["--seed", str(given.seed), "--blows", str(given.blows)]
    campaigning = subprocess.Popen(line.within(HOME, words), stdout=subprocess.PIPE, text=True)
    assert campaigning.stdout is not None
    for said in campaigning.stdout:
        match said.split():
            case ["@cut", one, other, both]:
                line.cut(int(one), int(other), both=both == "1")
            case ["@mend"]:
                line.mend()
            case _:
                print(said, end="", flush=True)
    code = campaigning.wait()
    for site, service in enumerate(services):
        service.terminate()
        service.wait(30)
        print((folder / f"site{site}.log").read_text(), end="")
    return code


def main() -> int:
    """The program."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--blows", type=int, default=24)
    parser.add_argument("--delay-ms", type=float, default=100.0, help="one way")
    parser.add_argument("--loss", type=float, default=0.02)
    parser.add_argument("--within", nargs="+", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.within:
        folder, token, *hosts = given.within
        return campaign(Path(folder), token, given.seed, given.blows, hosts)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        words = [sys.executable, "-m", "onika.host.sessions.users", "owner", "owner", str(folder / "users")]
        token = subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()
        (folder / "list").write_text(LIST)
        names = ",".join(f"IP:10.9.0.{site + 1}" for site in range(SITES))
        asked = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"]
        asked += ["-keyout", f"{name}/tls.key", "-out", f"{name}/tls.crt", "-subj", "/CN=far"]
        subprocess.run([*asked, "-addext", f"subjectAltName={names}"], check=True, capture_output=True)
        (folder / "tls.key").chmod(0o600)
        delay_s = given.delay_ms / 1e3
        with FarLine(SITES + 1, delay_s, jitter_s=delay_s / 10, loss=given.loss, seed=given.seed) as line:
            return serve(line, folder, token, given)


if __name__ == "__main__":
    sys.exit(main())
