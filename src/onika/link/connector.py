"""A connector: it opens connections in threads of their own, so that no caller waits for the network."""

import os
import threading
from collections import deque
from collections.abc import Callable

from onika.link.carrier import Carrier
from onika.link.channel import Channel
from onika.link.lost import LinkLost


class ThreadConnector:
    """One thread for each opening under way; readable when one has finished."""

    pending = 0

    def __init__(self, opening: Callable[[Channel], Carrier]) -> None:
        self._opening = opening
        self._finished: deque[tuple[Channel, Carrier | LinkLost]] = deque()
        self._lock = threading.Lock()
        self._is_closed = False
        self._awake, self._waker = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)

    def fileno(self) -> int:
        """To wait for; -1 after `close`."""
        return -1 if self._is_closed else self._awake

    def dial(self, channel: Channel) -> None:
        """Begin to open a connection."""
        threading.Thread(target=self._open, args=(channel,), name=f"onika {channel.name}", daemon=True).start()

    def finished(self) -> list[tuple[Channel, Carrier | LinkLost]]:
        """What came of those that were begun."""
        with self._lock:
            if not self._is_closed:
                self._sleep_again()
            taken = list(self._finished)
            self._finished.clear()
        return taken

    def close(self) -> None:
        """Nothing more is wanted; what is still being opened is closed as soon as it is there."""
        with self._lock:
            if self._is_closed:
                return
            self._is_closed = True
            os.close(self._awake)
            os.close(self._waker)
            for _, came in self._finished:
                _let_go(came)
            self._finished.clear()

    def _open(self, channel: Channel) -> None:
        came: Carrier | LinkLost
        try:
            came = self._opening(channel)
        except LinkLost as why:
            came = why
        with self._lock:
            if self._is_closed:
                _let_go(came)
                return
            self._finished.append((channel, came))
            os.write(self._waker, b"x")

    def _sleep_again(self) -> None:
        try:
            os.read(self._awake, 4096)
        except BlockingIOError:
            return


def _let_go(came: Carrier | LinkLost) -> None:
    if not isinstance(came, LinkLost):
        came.close()
