"""The datagrams by which the runtimes of one run say to each other where their flows are; nothing here waits.

They go from runtime to runtime: no environment is needed once the pacts are handed round. Where no way leads to another
one it is silent, as if it were gone.
"""

import contextlib
import socket
from collections.abc import Mapping
from dataclasses import dataclass

from onika.engine.rendezvous_exchange import RendezvousExchange, TagOrder
from onika.engine.rendezvous_terms import EVERY_NS
from onika.link.datagrams.pact import Pact
from onika.wire.rendezvous import decode, encode

_MOST = 2_048
_AT_ONCE = 200
"""So many datagrams at most are read at a time: a flood does not keep the program from all else."""


@dataclass(frozen=True, slots=True)
class Correspondent:
    """Where another runtime of the run is reached, and its pact."""

    host: str
    port: int
    pact: Pact


class RendezvousSocket:
    """Where datagrams for a run arrive, before it is known who the others are."""

    def __init__(self, host: str = "127.0.0.1") -> None:
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        self.socket = socket.socket(family, socket.SOCK_DGRAM)
        self.pact = Pact.drawn()
        try:
            self.socket.bind((host, 0))
            self.socket.setblocking(False)
        except OSError:
            self.socket.close()
            raise
        self.port: int = self.socket.getsockname()[1]

    def fileno(self) -> int:
        """To wait for datagrams."""
        return self.socket.fileno()

    def close(self) -> None:
        """Nothing arrives any more."""
        self.socket.close()


class RendezvousChannel:
    """Carries what an exchange says; `now_ns` is always the runtime's own clock."""

    def __init__(
        self, here: RendezvousSocket, exchange: RendezvousExchange, others: Mapping[int, Correspondent]
    ) -> None:
        self.exchange = exchange
        self._here = here
        self._others = others
        self._counts = dict.fromkeys(others, 0)
        self._due_ns = 0
        self._states: list[object] = []

    def fileno(self) -> int:
        """To wait for datagrams."""
        return self._here.fileno()

    def receive(self, now_ns: int) -> list[TagOrder]:
        """Hear what has come."""
        orders: list[TagOrder] = []
        for _ in range(_AT_ONCE):
            try:
                datagram = self._here.socket.recv(_MOST)
            except OSError:  # nothing more is there, or a way is gone: then somebody is silent
                break
            opened = self._here.pact.open(datagram)
            report = decode(opened[1]) if opened is not None else None
            if opened is not None and report is not None:
                orders += self.exchange.hear(opened[0], report, now_ns)
        return orders

    def look(self, now_ns: int) -> list[TagOrder]:
        """Let time pass."""
        return self.exchange.look(now_ns)

    def speak(self, now_ns: int) -> None:
        """Say how everything stands, if something is new, or it is time."""
        states: list[object] = [meeting.state for meeting in self.exchange.meetings.values()]
        states.append(self.exchange.is_stopped)
        if states == self._states and now_ns < self._due_ns:
            return
        self._states = states
        self._due_ns = now_ns + EVERY_NS
        for site, other in self._others.items():
            self._counts[site] += 1
            body = encode(self.exchange.report(site, now_ns))
            with contextlib.suppress(OSError):
                self._here.socket.sendto(other.pact.seal(self._counts[site], body), (other.host, other.port))

    def due_ns(self) -> int:
        """When something is to be said, or time changes something."""
        due_ns = self.exchange.due_ns()
        return self._due_ns if due_ns is None else min(due_ns, self._due_ns)

    def close(self) -> None:
        """Say no more."""
        self._here.close()
