"""The heartbeat of a process: when it was last alive and whose code it runs, in shared memory (law 30)."""

from time import monotonic_ns

from onika.ring.segment import Segment

SIZE = 4096
_NAME_AT = 64
_NAME_SIZE = 256


class Heartbeat:
    """Written by the process itself, read by the supervisor; two words and a name."""

    def __init__(self, segment: Segment) -> None:
        self._words = segment.view[:32].cast("Q")
        self._name = segment.view[_NAME_AT : _NAME_AT + _NAME_SIZE]
        self._known: dict[str, bytes] = {}

    def beat(self) -> None:
        """Alive now."""
        self._words[0] = monotonic_ns()

    def is_slow(self, slow: bool) -> None:
        """Announce work that may take long (loading, initialising), or its end."""
        self._words[1] = slow

    def watch(self, task: str) -> None:
        """Whose code runs from now on; "" for the executive's own."""
        data = self._known.get(task)
        if data is None:
            data = self._known[task] = task.encode()[:_NAME_SIZE].ljust(_NAME_SIZE, b"\0")
        self._name[:] = data

    @property
    def last_ns(self) -> int:
        """When it was last alive (monotonic clock), 0 before the first beat."""
        return self._words[0]

    @property
    def takes_long(self) -> bool:
        """Whether it has announced long work."""
        return bool(self._words[1])

    @property
    def task(self) -> str:
        """Whose code runs."""
        return bytes(self._name).rstrip(b"\0").decode("utf-8", "replace")
