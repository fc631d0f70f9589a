"""The messages waiting for one browser: answers are never lost, patches stay in order, only the newest frame counts."""

import asyncio
from collections import deque
from collections.abc import Callable

_MOST = 4 * 1024 * 1024
"""Bytes of patches that may wait; a browser that is slower than that is sent everything anew instead."""


class Outbox:
    """Messages on their way to one browser; `snapshot` makes the message that says everything."""

    def __init__(self, snapshot: Callable[[], bytes]) -> None:
        self._snapshot = snapshot
        self._waiting: deque[tuple[bytes, bool]] = deque()
        self._size = 0
        self._frame: bytes | None = None
        self._is_behind = True
        self._some = asyncio.Event()
        self._some.set()

    def patch(self, message: bytes) -> None:
        """Something has changed."""
        if self._is_behind:
            return  # the snapshot that is due says it
        self._waiting.append((message, True))
        self._size += len(message)
        if self._size > _MOST:
            self._waiting = deque(message for message in self._waiting if not message[1])
            self._size = 0
            self._is_behind = True
        self._some.set()

    def put(self, message: bytes) -> None:
        """An answer, or a line of the log."""
        self._waiting.append((message, False))
        self._some.set()

    def frame(self, message: bytes) -> None:
        """The newest values, in place of those that were not sent yet."""
        self._frame = message
        self._some.set()

    async def next(self) -> bytes:
        """What is to be sent next; waits for it."""
        await self._some.wait()
        message = self._taken()
        if not self._waiting and self._frame is None:
            self._some.clear()
        return message

    def _taken(self) -> bytes:
        if self._is_behind:
            self._is_behind = False
            return self._snapshot()
        if self._waiting:
            message, is_patch = self._waiting.popleft()
            self._size -= len(message) if is_patch else 0
            return message
        frame, self._frame = self._frame or b"", None
        return frame
