"""An orderly exit: SIGTERM and SIGHUP end the program as Ctrl-C does, so that the terminal is left as it was."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_TOLD = (signal.SIGTERM, signal.SIGHUP)


@contextmanager
def in_order() -> Iterator[None]:
    """Within it SIGTERM and SIGHUP raise SystemExit, as Ctrl-C a KeyboardInterrupt; what is ignored stays so."""

    def end(number: int, _frame: FrameType | None) -> None:
        raise SystemExit(128 + number)

    caught = [number for number in _TOLD if signal.getsignal(number) is not signal.SIG_IGN]  # as `nohup` wants it
    former = {number: signal.signal(number, end) for number in caught}
    try:
        yield
    finally:
        for number, handler in former.items():
            signal.signal(number, handler)
