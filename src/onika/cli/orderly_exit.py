"""An end in order: to be told to end is an end like any other, so that the terminal is left as it was."""

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

    heard = [one for one in _TOLD if signal.getsignal(one) is not signal.SIG_IGN]  # as `nohup` wants it
    former = {one: signal.signal(one, end) for one in heard}
    try:
        yield
    finally:
        for one, handler in former.items():
            signal.signal(one, handler)
