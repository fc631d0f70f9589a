"""Something worked out in a copy of this process, so that nothing here waits for it, nor for the interpreter's lock.

The copy has all that this process has, and ordinary priority; what it comes to returns as bytes, in memory only.
"""

import gc
import os
import traceback
from collections.abc import Callable
from contextlib import suppress

from onika.host.processes.forked_process import ForkedProcess
from onika.host.processes.process_title import entitle
from onika.link.child.launcher import die_with_parent

_ERRORS, _STANDARD = 2, 3
"""The descriptors below are input and outputs."""


class ForkedWork:
    """The copy, begun by the only thread of this process; raises OSError where there is no room for it.

    A ValueError of `work` is a fault of the user's and says nothing here: the copy has come to nothing.
    """

    def __init__(self, work: Callable[[], bytes]) -> None:
        self._result = os.memfd_create("forked-work")
        parent = os.getpid()
        try:
            pid = os.fork()
        except OSError:
            os.close(self._result)
            raise
        if not pid:
            _end_with(work, self._result, parent)
        self._process = ForkedProcess(pid)

    def wait(self) -> bytes | None:
        """What it has come to, when it is done; None: it came to nothing."""
        code = self._process.wait()
        with os.fdopen(self._result, "rb") as result:
            result.seek(0)
            return result.read() if code == 0 else None


def _end_with(work: Callable[[], bytes], result: int, parent: int) -> None:
    """In the copy: nothing of the copied program goes on, and what that has open ends with it."""
    code = 1
    try:
        die_with_parent(parent)
        gc.disable()
        entitle(__name__)
        os.closerange(_STANDARD, result)
        os.closerange(result + 1, os.sysconf("SC_OPEN_MAX"))
        with suppress(ValueError), os.fdopen(result, "wb") as written:
            written.write(work())
            code = 0
    except BaseException:
        with suppress(OSError):
            os.write(_ERRORS, traceback.format_exc().encode())
    finally:
        os._exit(code)
