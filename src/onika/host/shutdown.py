"""The signals that ask a runtime to end: they are noted, and it ends in order."""

import signal
from types import FrameType


class ShutdownSignals:
    """Notes SIGTERM, and Ctrl-C where no other program started this one (else it is that program's to answer)."""

    def __init__(self, is_launched: bool) -> None:
        self.is_asked = False
        signal.signal(signal.SIGTERM, self._note)
        signal.signal(signal.SIGINT, signal.SIG_IGN if is_launched else self._note)

    def _note(self, _number: int, _frame: FrameType | None) -> None:
        self.is_asked = True
