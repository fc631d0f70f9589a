"""Runtimes as processes that carry out flows of one application together, with lines between them that a test cuts.

They are launched as an environment elsewhere would reach them; datagrams from one to another go through a `CutLine`.
"""

import heapq
import os
import secrets
import select
import socket
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from time import monotonic

from onika.desk.run.remote_runtime import RemoteRuntime
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.link.address import Address
from onika.link.websocket_opening import WebSocketOpening
from onika.wire import event, request
from onika.wire.plan import Plan
from onika.wire.rendezvous_link import (
    Linked,
    LinkedRuntime,
    LinkRuntimes,
    MeetingTerms,
    OfferPact,
    PactOffered,
    SharedTag,
)

Way = Callable[[], float | None]
"""For how many seconds a datagram is under way; None: it is lost."""


class CutLine:
    """Passes datagrams on to a port of this machine, in a thread, but while it is cut."""

    def __init__(self, port: int, way: Way = lambda: 0.0) -> None:
        self.is_cut = False
        self._to = ("127.0.0.1", port)
        self._way = way
        self._under_way: list[tuple[float, int, bytes]] = []
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.port: int = self._socket.getsockname()[1]
        self._over = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Pass nothing on any more."""
        self._over = True
        self._thread.join()
        self._socket.close()

    def _run(self) -> None:
        count = 0
        while not self._over:
            wait_s = min(0.1, self._under_way[0][0] - monotonic()) if self._under_way else 0.1
            if select.select([self._socket], [], [], max(0.0, wait_s))[0]:
                datagram, way_s = self._socket.recv(2_048), self._way()
                count += 1
                if not self.is_cut and way_s is not None:
                    heapq.heappush(self._under_way, (monotonic() + way_s, count, datagram))
            while self._under_way and self._under_way[0][0] <= monotonic():
                self._socket.sendto(heapq.heappop(self._under_way)[2], self._to)


class MeetingRuntime:
    """A runtime in wall time, and a session with it that holds everything."""

    def __init__(self, folder: Path, users: Path, token: str, *options: str) -> None:
        folder.mkdir()
        self._output = folder / "output"
        with self._output.open("wb") as output:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--users", str(users), *options],
                stdout=subprocess.PIPE, stderr=output, env=os.environ | {"XDG_STATE_HOME": str(folder)},
            )  # fmt: skip
        assert self.process.stdout is not None
        first = self.process.stdout.readline().decode()
        self.url = first.split(" on ")[1].split(",")[0].strip()
        address = Address.parse(self.url)
        self._session = RemoteRuntime(WebSocketOpening(address, token, None))
        self.client = self._session.__enter__()

    def ask(self, asked: request.Request) -> request.Response:
        """Ask something, and wait for the answer."""
        return self.client.ask(asked)

    def close(self) -> str:
        """End it; what it printed on its errors."""
        self._session.__exit__(None, None, None)
        self.process.terminate()
        self.process.communicate(timeout=60)
        return self._output.read_text()


class Meeting:
    """Some runtimes; `events` are those of the present run, with the number of the runtime that said them."""

    def __init__(self, folder: Path, *options: str, count: int = 2, way: Way = lambda: 0.0) -> None:
        self._way = way
        users = folder / "users"
        words = [sys.executable, "-m", "onika.host.sessions.users", "owner", "owner", str(users)]
        self.token = subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()
        self.runtimes = [
            MeetingRuntime(folder / f"site{number}", users, self.token, *options) for number in range(count)
        ]
        self.events: list[tuple[int, event.Event]] = []
        self.lines: list[CutLine] = []
        self.terms = MeetingTerms(0, 0)

    def link(self, *plans: Plan) -> list[Linked]:
        """Prepare a plan on each, and link them at the tag `x`; what they answer."""
        for runtime, plan in zip(self.runtimes, plans, strict=True):
            prepared = runtime.ask(request.Prepare(plan, ()))
            assert isinstance(prepared, request.Prepared)
            assert not prepared.faults, prepared.faults
        pacts = [runtime.ask(OfferPact()) for runtime in self.runtimes]
        self._close_lines()
        partners = []
        for site, pact in enumerate(pacts):
            assert isinstance(pact, PactOffered)
            self.lines.append(CutLine(pact.port, self._way))
            port = self.lines[-1].port
            partners.append(LinkedRuntime(site, f"site{site}", "127.0.0.1", port, pact.name, pact.key, pact.epoch))
        answers: dict[int, request.Response] = {}
        run = secrets.token_bytes(16)

        def ask(site: int) -> None:
            others = tuple(partner for partner in partners if partner.site != site)
            tags = (SharedTag("x", tuple(range(len(partners)))),)
            answers[site] = self.runtimes[site].ask(LinkRuntimes(run, site, others, tags))

        asking = [threading.Thread(target=ask, args=(site,)) for site in range(len(partners))]
        for thread in asking:
            thread.start()
        for thread in asking:
            thread.join()
        linked = [answer for _, answer in sorted(answers.items()) if isinstance(answer, Linked)]
        ways = [way for answer in linked for way in answer.ways]
        clock_ns = max(way.clock_ns for way in ways) * 5 // 4 + 1_000_000
        self.terms = MeetingTerms(max(way.trip_ns for way in ways) // 2, clock_ns)
        return linked

    @property
    def alone_s(self) -> float:
        """After how long whoever has begun alone is held."""
        return RendezvousTerms(self.terms.one_way_ns, self.terms.clock_ns).alone_ns * 1e-9

    def begin(self, on_error: str = "wait") -> None:
        """Begin the run on all."""
        self.events.clear()
        for runtime in self.runtimes:
            done = runtime.ask(request.Begin(meets=self.terms, on_error=on_error, settle_s=0.0))
            assert isinstance(done, request.Done), done

    def listen(self, seconds: float) -> None:
        """Hear all of them for so long, or until every run is over."""
        until = monotonic() + seconds
        while monotonic() < until and len(self.of(event.Result)) < len(self.runtimes):
            for number, runtime in enumerate(self.runtimes):
                self.events += [(number, message) for message in runtime.client.events(0.01)]

    def of(self, kind: type) -> list[tuple[int, event.Event]]:
        """What was said of one kind."""
        return [(number, message) for number, message in self.events if isinstance(message, kind)]

    def close(self) -> str:
        """End everything; what was printed."""
        printed = "".join(runtime.close() for runtime in self.runtimes)
        self._close_lines()
        return printed

    def _close_lines(self) -> None:
        for line in self.lines:
            line.close()
        self.lines.clear()
