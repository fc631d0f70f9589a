"""A process that is begun and ended beside a loop that steps worlds: neither is waited for.

`subprocess` lets its caller stand still until the new process has become another program, and until an ended one is
gone. Both have no more than ordinary priority, so that it is long where the processors are busy.
"""

import os
import signal
import sys
import warnings
from collections.abc import Callable, Mapping, Sequence
from threading import Thread

_STANDARD = 3
"""Input and outputs, which lead nowhere."""


class BegunProcess:
    """One of our own modules as a program; it has these descriptors, and no other of ours. Raises OSError.

    before  what takes long, and is done in the new process before it becomes that program: it has all that this one has
    """

    def __init__(
        self,
        module: str,
        words: Sequence[str],
        descriptors: Sequence[int],
        environment: Mapping[str, str],
        before: Callable[[], None] = lambda: None,
    ) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # that threads are gone: it becomes another program
            self.pid = os.fork()
        if not self.pid:
            _become([sys.executable, "-m", module, *words], descriptors, environment, before)

    def end(self) -> None:
        """It is ended, and gone some time later."""
        os.kill(self.pid, signal.SIGKILL)
        Thread(target=os.waitpid, args=(self.pid, 0), daemon=True).start()


def _become(
    words: Sequence[str], descriptors: Sequence[int], environment: Mapping[str, str], before: Callable[[], None]
) -> None:
    """In the new process."""
    try:
        before()
        nowhere = os.open(os.devnull, os.O_RDWR)
        for number in range(_STANDARD):
            os.dup2(nowhere, number)
        for descriptor in descriptors:
            os.set_inheritable(descriptor, True)
        os.execve(words[0], [*words], dict(environment))  # noqa: S606 - our own code, no shell
    finally:
        os._exit(1)
