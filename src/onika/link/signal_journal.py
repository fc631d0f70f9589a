"""The signal journal: the numbered signals of one life (epoch) of a runtime, kept so that they can be sent again."""


class SignalJournal:
    """Signals 1, 2, 3 … of one epoch; keeps the newest within bounds and forgets the oldest, never blocks.

    A reader that needs a forgotten one cannot be served any more and has to begin anew.
    """

    def __init__(self, epoch: str, keep: int = 20_000, keep_bytes: int = 16 * 1024 * 1024) -> None:
        if not epoch:
            raise ValueError("expected an epoch that names this life of the runtime, found an empty name")
        self.epoch = epoch
        self.last = 0
        self._first = 1
        self._bodies: dict[int, bytes] = {}
        self._bytes = 0
        self._keep = keep
        self._keep_bytes = keep_bytes

    def append(self, body: bytes) -> int:
        """Write a signal down; its number."""
        self.last += 1
        self._bodies[self.last] = body
        self._bytes += len(body)
        while len(self._bodies) > self._keep or (self._bytes > self._keep_bytes and self._first < self.last):
            self._bytes -= len(self._bodies.pop(self._first))
            self._first += 1
        return self.last

    def reaches_back_to(self, seq: int) -> bool:
        """Whether one who has signal `seq` and all before it can be told the rest."""
        return self._first - 1 <= seq <= self.last

    def body(self, seq: int) -> bytes:
        """The signal of that number; raises KeyError when it is forgotten or does not exist yet."""
        return self._bodies[seq]
