import os
import signal

import pytest

from onika.process.orderly_exit import in_order


@pytest.fixture
def usual():
    """What stands where no `nohup` has hidden a signal from the tests themselves."""
    former = {number: signal.signal(number, signal.SIG_DFL) for number in (signal.SIGTERM, signal.SIGHUP)}
    yield signal.SIG_DFL
    for number, handler in former.items():
        signal.signal(number, handler)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_to_be_told_to_end_is_an_end_like_any_other(usual, number):  # law 27
    is_left = []
    with pytest.raises(SystemExit) as ended, in_order():
        try:
            os.kill(os.getpid(), number)
        finally:
            is_left.append(True)
    assert ended.value.code == 128 + number
    assert is_left == [True]
    assert signal.getsignal(number) is usual


def test_what_is_to_be_ignored_stays_ignored(usual):  # as `nohup` has it
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    with in_order():
        os.kill(os.getpid(), signal.SIGHUP)
    assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
