"""A runtime at the other end of a descriptor, as a thread that talks with it sees it.

line = RuntimeLine()
thread = RuntimeThread(lambda url, token, simulator=None: line, post)
line.silent = (live.Change,)        # it does not answer these
line.say(LinkLost(...))             # what it says by itself
"""

import contextlib
import os
from collections import deque
from collections.abc import Iterator
from typing import Any

from kit.desk.live_runtime import LiveRuntime
from onika.desk.run.runtime_conversation import NumberedResponse
from onika.wire import event, request


class RuntimeLine:
    """Answers as `runtime` does, but for the kinds in `silent`; what it is to say can be planned from another thread.

    is_heard    whether it counts as heard just now
    """

    def __init__(self) -> None:
        self.runtime = LiveRuntime()
        self.asked: list[request.Request] = []
        self.silent: tuple[type, ...] = ()
        self.seen: dict[str, bytes] = {}
        self.is_left = False
        self.is_heard = True
        self.pid: int | None = None
        self._words: deque[Any] = deque()
        self._reader, self._writer = os.pipe()
        os.set_blocking(self._reader, False)

    def send(self, message: request.Request) -> int:
        """Ask without waiting; the number of the reply."""
        self.asked.append(message)
        number = len(self.asked)
        if not isinstance(message, self.silent):
            self.say(NumberedResponse(number, self.runtime.ask(message)), *self.runtime.events(0.0))
        return number

    def say(self, *words: Any) -> None:
        """Let it say something by itself; an exception is how it ends."""
        self._words.extend(words)
        os.write(self._writer, b"!")

    def messages(self, timeout_s: float = 0.0) -> Iterator[event.Event | NumberedResponse]:
        """What it has said since."""
        del timeout_s
        with contextlib.suppress(BlockingIOError):
            os.read(self._reader, 4096)
        while self._words:
            word = self._words.popleft()
            if isinstance(word, Exception):
                raise word
            yield word

    def readings(self) -> dict[str, bytes]:
        """The newest values since the last call."""
        taken, self.seen = self.seen, {}
        return taken

    def readers(self) -> list[int]:
        """What to wait for."""
        return [self._reader]

    def writers(self) -> list[int]:
        """Nothing is ever kept back."""
        return []

    def due_s(self) -> float | None:
        """Nothing becomes due."""
        return None

    def __enter__(self) -> "RuntimeLine":
        return self

    def __exit__(self, *_fault: object) -> None:
        self.is_left = True
        os.close(self._reader)
        os.close(self._writer)
