"""A process that was begun as a copy of another: what its parent sees of it."""

import os
import select
import signal
import subprocess


class ForkedProcess:
    """A child of this process by its id; it is looked after as a `subprocess.Popen` is."""

    def __init__(self, pid: int) -> None:
        self.pid = pid
        self.returncode: int | None = None
        """Its exit code, negative for the signal that ended it; None as long as nobody has seen it end."""

    def poll(self) -> int | None:
        """Its exit code; None while it lives. No zombie is left."""
        if self.returncode is None:
            ended, status = os.waitpid(self.pid, os.WNOHANG)
            if ended:
                self.returncode = os.waitstatus_to_exitcode(status)
        return self.returncode

    def wait(self, timeout: float | None = None) -> int:
        """Its exit code, when it has ended; raises subprocess.TimeoutExpired after so many seconds."""
        code = self.poll()
        if code is None:
            end = os.pidfd_open(self.pid)
            try:
                select.select([end], [], [], timeout)
            finally:
                os.close(end)
            code = self.poll()
        if code is None:
            raise subprocess.TimeoutExpired(f"process {self.pid}", timeout or 0.0)
        return code

    def kill(self) -> None:
        """End it now; nothing happens where it has ended."""
        if self.poll() is None:
            os.kill(self.pid, signal.SIGKILL)
