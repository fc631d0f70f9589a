"""The last words of a process: whose code it runs and why it ended itself, in memory that its parent keeps (law 30)."""

from msgspec import MsgspecError, msgpack

from onika.words.reason import NOTHING, Reason

SIZE = 2048
_NAME_SIZE = 256
_REASON_AT = _NAME_SIZE + 2
_LONGEST = SIZE - _REASON_AT

_encode = msgpack.Encoder().encode
_decode = msgpack.Decoder(Reason).decode


class LastWords:
    """Written by the process itself, read by whoever has started it; both in the same shared memory."""

    def __init__(self, view: memoryview) -> None:
        self.name = view[:_NAME_SIZE]
        """Where it is noted whose code runs, as `name_of` it."""
        self._size = view[_NAME_SIZE:_REASON_AT]
        self._reason = view[_REASON_AT:SIZE]
        self._known: dict[str, bytes] = {}

    def watch(self, task: str) -> None:
        """Whose code runs from now on; "" for the executive's own."""
        data = self._known.get(task)
        if data is None:
            data = self._known[task] = name_of(task)
        self.name[:] = data

    def leave(self, reason: Reason) -> None:
        """Why the process is about to end itself; one that is too long is left out."""
        data = _encode(reason)
        if len(data) <= _LONGEST:
            self._reason[: len(data)] = data
            self._size[:] = len(data).to_bytes(2, "little")

    @property
    def task(self) -> str:
        """Whose code runs."""
        return bytes(self.name).rstrip(b"\0").decode("utf-8", "replace")

    @property
    def reason(self) -> Reason:
        """Why the process has ended itself; NOTHING where it said nothing, or what a module has scribbled there."""
        size = int.from_bytes(self._size, "little")
        try:
            return _decode(self._reason[:size])
        except MsgspecError:
            return NOTHING


def name_of(task: str) -> bytes:
    """The name of a task as it is noted: as many bytes for all."""
    return task.encode()[:_NAME_SIZE].ljust(_NAME_SIZE, b"\0")
