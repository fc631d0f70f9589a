"""Heartbeats as datagrams beside a connection: they queue behind nothing, and a lost one delays no other (X12).

Each says only that its sender is alive: the name of the connection, a count that only grows, and a seal over both.
The key is drawn for one connection and told over it, behind its token: nobody else can make a beat, and none counts
twice. A thread beats, so that an honest moment of work is no silence: as long as whoever serves the connection has come
by not long ago. A process that is stopped or gone is silent at once, one that is stuck soon.
"""

import contextlib
import secrets
import socket
import threading
from dataclasses import dataclass
from hmac import compare_digest
from time import monotonic_ns

from onika.link.datagrams.pact import COUNT, KEY, NAME, SEAL, sealed

HEADER = "Onika-Beats"
"""Of the answer that opens a connection: `PORT NAME KEY`, the latter in hexadecimal digits."""
EVERY_NS = 50_000_000
PATIENCE_NS = 750_000_000
"""For how long a beat speaks for a program that does not serve its connection."""
LENGTH = NAME + COUNT + SEAL


@dataclass(frozen=True, slots=True)
class HeartbeatKey:
    """What both ends of one connection know of its beats."""

    port: int
    name: bytes
    key: bytes

    def __repr__(self) -> str:
        """Without the key."""
        return f"HeartbeatKey(port={self.port}, name={self.name.hex()})"

    @classmethod
    def drawn(cls, port: int) -> "HeartbeatKey":
        """For a new connection."""
        return cls(port, secrets.token_bytes(NAME), secrets.token_bytes(KEY))

    @classmethod
    def parse(cls, header: str) -> "HeartbeatKey | None":
        """What the other end has told; None: it tells nothing that could be used."""
        words = header.split()
        try:
            port, name, key = int(words[0]), bytes.fromhex(words[1]), bytes.fromhex(words[2])
        except (ValueError, IndexError):
            return None
        fits = 0 < port < 65536 and len(name) == NAME and len(key) == KEY and len(words) == 3
        return cls(port, name, key) if fits else None

    def header(self) -> str:
        """As it is told."""
        return f"{self.port} {self.name.hex()} {self.key.hex()}"

    def beat(self, count: int) -> bytes:
        """The datagram."""
        head = self.name + count.to_bytes(COUNT, "big")
        return head + sealed(self.key, head)

    def count_in(self, datagram: bytes) -> int | None:
        """The count of a beat of this connection; None: it is none."""
        head, seal = datagram[:-SEAL], datagram[-SEAL:]
        if len(datagram) != LENGTH or head[:NAME] != self.name or not compare_digest(seal, sealed(self.key, head)):
            return None
        return int.from_bytes(head[NAME:], "big")


def name_in(datagram: bytes) -> bytes:
    """Whose beat it says that it is; empty: it is no beat."""
    return datagram[:NAME] if len(datagram) == LENGTH else b""


class HeartbeatCounter:
    """What is beaten beside one connection, and when no more. No I/O, no clock."""

    def __init__(self, heartbeat_key: HeartbeatKey) -> None:
        self._heartbeat_key = heartbeat_key
        self._count = 0
        self._served_ns: int | None = None

    def served(self, now_ns: int) -> None:
        """Whoever serves the connection has come by: so he is alive."""
        self._served_ns = now_ns

    def beat(self, now_ns: int) -> bytes | None:
        """The next beat; None: nobody serves the connection, and it would be a lie."""
        if self._served_ns is None or now_ns - self._served_ns >= PATIENCE_NS:
            return None
        self._count += 1
        return self._heartbeat_key.beat(self._count)


class HeartbeatSender:
    """Sends the beats of one connection to the machine where that ends; where none gets through, nothing is lost."""

    def __init__(self, heartbeat_key: HeartbeatKey, host: str, family: int) -> None:
        self._counter = HeartbeatCounter(heartbeat_key)
        self._over = threading.Event()
        self._socket = socket.socket(family, socket.SOCK_DGRAM)
        self._socket.setblocking(False)
        with contextlib.suppress(OSError):
            self._socket.connect((host, heartbeat_key.port))
        threading.Thread(target=self._run, name="onika beats", daemon=True).start()

    def served(self) -> None:
        """Whoever serves the connection has come by."""
        self._counter.served(monotonic_ns())

    def close(self) -> None:
        """Beat no more."""
        self._over.set()

    def _run(self) -> None:
        with self._socket:
            while not self._over.wait(EVERY_NS * 1e-9):
                beat = self._counter.beat(monotonic_ns())
                if beat is not None:
                    with contextlib.suppress(OSError):  # nobody listens there, or a wall stands between: TCP is left
                        self._socket.send(beat)
