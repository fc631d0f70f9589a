"""Where the runtime's processes print: a full pipe drops text, it never blocks a cycle (law 30)."""

import contextlib
import io
import os
import sys


class OutputPipe(io.TextIOBase):
    """A text stream on a descriptor that never waits."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor
        os.set_blocking(descriptor, False)

    def writable(self) -> bool:
        """Yes."""
        return True

    def write(self, text: str) -> int:
        """Print what fits; the rest is dropped."""
        with contextlib.suppress(OSError):  # full or closed: printing is never worth a missed deadline
            os.write(self._descriptor, text.encode("utf-8", "replace"))
        return len(text)


def open_output_pipes() -> None:
    """Replace standard output and error of this process."""
    sys.stdout, sys.stderr = OutputPipe(1), OutputPipe(2)
