"""The variables of a recording that were read whole; the one that was wanted longest ago is forgotten first."""

from threading import Lock

from onika.record.downsampled import Samples

_MOST = 256 << 20
"""Bytes of them that are kept."""


class VariableCache:
    """By `SUBSYSTEM/NAME`; filled in one thread and looked at in another."""

    def __init__(self, most: int = _MOST) -> None:
        self._most = most
        self._lock = Lock()
        self._known: dict[str, Samples] = {}

    def get(self, address: str) -> Samples | None:
        """Those of a variable; None: it has to be read."""
        with self._lock:
            samples = self._known.pop(address, None)
            if samples is not None:
                self._known[address] = samples
            return samples

    def put(self, address: str, samples: Samples) -> None:
        """Keep them; the newest are kept in any case."""
        with self._lock:
            self._known.pop(address, None)
            self._known[address] = samples
            while len(self._known) > 1 and sum(samples.bytes for samples in self._known.values()) > self._most:
                del self._known[next(iter(self._known))]
