"""The newest output of a child process: it is always read, so that the child never blocks."""

import os
import select
import threading


class OutputTail:
    """Reads a pipe in a thread of its own until its end or until `close`; owns the descriptor from now on."""

    def __init__(self, descriptor: int, keep: int = 64 * 1024) -> None:
        self._descriptor = descriptor
        self._keep = keep
        self._kept = bytearray()
        self._lock = threading.Lock()
        self._wake, self._waker = os.pipe()
        self._thread = threading.Thread(target=self._run, name="onika child output", daemon=True)
        self._thread.start()

    def text(self) -> str:
        """What was printed last; bytes that are no UTF-8 are shown as such."""
        with self._lock:
            return self._kept.decode("utf-8", "backslashreplace")

    def close(self, timeout_s: float = 1.0) -> None:
        """Take what is still there up to the end of the pipe, for so long at most, and let it go."""
        self._thread.join(timeout_s)
        if self._waker >= 0:
            # a grandchild may hold the pipe open for ever
            os.close(self._waker)
            self._waker = -1
            self._thread.join()
            os.close(self._wake)
            os.close(self._descriptor)

    def _run(self) -> None:
        poller = select.poll()
        poller.register(self._descriptor, select.POLLIN)
        poller.register(self._wake, select.POLLIN)
        while True:
            ready = dict(poller.poll())
            if self._descriptor not in ready:
                return
            data = os.read(self._descriptor, 64 * 1024)
            if not data:
                return
            with self._lock:
                self._kept += data
                del self._kept[: -self._keep]
            if self._wake in ready:
                return
