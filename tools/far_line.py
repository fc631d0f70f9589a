"""Sites far from each other on one machine: network namespaces, and between them a line with a delay, losses and cuts.

Each site is a namespace with the address 10.9.0.1, 10.9.0.2 …; what it sends comes through a TUN device to a thread of
this process, which lets it go on when its time has come, to whom it is addressed. It needs root, and works where the
kernel has no `sch_netem`.
"""

import ctypes
import fcntl
import heapq
import os
import select
import struct
import subprocess
from collections.abc import Sequence
from pathlib import Path
from random import Random
from threading import Thread
from time import monotonic
from types import TracebackType
from typing import Self

_NEW_NETWORK = 0x40000000  # CLONE_NEWNET
_TUNSETIFF, _TUN_NO_PI = 0x400454CA, 0x1001
_BURST = 64
_TO = slice(16, 20)
"""Where an IPv4 packet says to whom it goes."""


class FarLine:
    """Namespaces called PREFIX0, PREFIX1 …; all delays are of one way."""

    def __init__(self, sites: int, delay_s: float, *, jitter_s: float = 0.0, loss: float = 0.0, seed: int = 1) -> None:
        self.names = [f"onika{os.getpid()}-{site}" for site in range(sites)]
        self.cuts: set[tuple[int, int]] = set()
        """From which site to which nothing goes through."""
        self.is_over = False
        self._delay_s, self._jitter_s, self._loss = delay_s, jitter_s, loss
        self._random = Random(seed)
        self._ends: list[int] = []
        self._thread = Thread(target=self._carry, daemon=True)

    def __enter__(self) -> Self:
        for name in self.names:
            _ip("netns", "add", name)
        self._ends = [_tun(name, f"10.9.0.{site + 1}") for site, name in enumerate(self.names)]
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None, _: TracebackType | None) -> None:
        self.is_over = True
        self._thread.join()
        for end in self._ends:
            os.close(end)
        for name in self.names:
            subprocess.run(["ip", "netns", "del", name], check=False)

    def address(self, site: int) -> str:
        """Where a site is."""
        return f"10.9.0.{site + 1}"

    def within(self, site: int, words: Sequence[str]) -> list[str]:
        """A command as it is begun at a site."""
        return ["ip", "netns", "exec", self.names[site], *words]

    def cut(self, one: int, other: int, *, both: bool = True) -> None:
        """From now on nothing goes from one to the other, nor back."""
        self.cuts |= {(one, other), (other, one)} if both else {(one, other)}

    def mend(self) -> None:
        """Everything goes through again."""
        self.cuts = set()

    def _carry(self) -> None:
        waiting: list[tuple[float, int, int, bytes]] = []
        last = dict.fromkeys(self._ends, 0.0)
        count = 0
        while not self.is_over:
            wait_s = max(0.0, waiting[0][0] - monotonic()) if waiting else 0.05
            for end in select.select(self._ends, [], [], min(wait_s, 0.05))[0]:
                for packet in _read(end):
                    to = self._destination(self._ends.index(end), packet)
                    if to is None:
                        continue
                    at = monotonic() + self._delay_s + self._random.gauss(0.0, self._jitter_s / 2)
                    last[end], count = max(at, last[end]), count + 1  # as on most routes, order is kept
                    heapq.heappush(waiting, (last[end], count, to, packet))
            while waiting and waiting[0][0] <= monotonic():
                _write(heapq.heappop(waiting)[2:])

    def _destination(self, site: int, packet: bytes) -> int | None:
        """The end of the line at which a packet comes out; None: nowhere."""
        to = packet[_TO][-1] - 1 if len(packet) >= _TO.stop and packet[0] >> 4 == 4 else -1
        if not 0 <= to < len(self._ends) or (site, to) in self.cuts or self._random.random() < self._loss:
            return None
        return self._ends[to]


def _read(end: int) -> list[bytes]:
    packets: list[bytes] = []
    try:
        while len(packets) < _BURST:
            packets.append(os.read(end, 65536))
    except BlockingIOError:
        pass
    return packets


def _write(due: tuple[int, bytes]) -> None:
    try:
        os.write(*due)
    except OSError:
        return  # the site is gone, or takes nothing


def _tun(name: str, address: str) -> int:
    """A TUN device inside a namespace; its descriptor works from here."""
    system = ctypes.CDLL(None, use_errno=True)
    home = os.open("/proc/self/ns/net", os.O_RDONLY | os.O_CLOEXEC)
    there = os.open(Path("/run/netns") / name, os.O_RDONLY | os.O_CLOEXEC)
    try:
        if system.setns(there, _NEW_NETWORK) != 0:
            raise OSError(ctypes.get_errno(), "setns")
        end = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK | os.O_CLOEXEC)
        fcntl.ioctl(end, _TUNSETIFF, struct.pack("16sH22x", b"far0", _TUN_NO_PI))
    finally:
        system.setns(home, _NEW_NETWORK)
        os.close(home)
        os.close(there)
    for words in (("addr", "add", f"{address}/24", "dev", "far0"), ("link", "set", "far0", "up")):
        _ip("-n", name, *words)
    _ip("-n", name, "link", "set", "lo", "up")
    route = ("10.9.0.0/24", "dev", "far0", "congctl", "cubic", "src", address)  # which paces TCP on most systems
    _ip("-n", name, "route", "replace", *route)
    return end


def _ip(*words: str) -> None:
    subprocess.run(["ip", *words], check=True)
