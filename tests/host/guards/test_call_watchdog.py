import signal

import pytest

from onika.host.guards.call_watchdog import CallWatchdog
from onika.runtime.error import ModuleError


@pytest.fixture
def timer():
    """The timer of this process, given back as it was."""
    former = signal.getsignal(signal.SIGALRM)
    yield
    signal.setitimer(signal.ITIMER_REAL, 0.0)
    signal.signal(signal.SIGALRM, former)


def run_for_ever():
    """What the timer interrupts, once."""
    try:
        while True:
            pass
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)


def test_a_call_that_never_returns_is_interrupted_and_named(timer):  # law 15
    patience = CallWatchdog(0.01)
    patience.watch("flow0/sick")
    with pytest.raises(ModuleError, match=r"a call of task flow0/sick has not returned for 0\.01 s"):
        run_for_ever()


def test_one_that_catches_it_is_interrupted_again(timer):  # law 15
    patience, caught = CallWatchdog(0.01), 0
    patience.watch("flow0/stubborn")
    while caught < 3:
        try:
            while True:
                pass
        except ModuleError:
            caught += 1
    patience.watch("")


def test_calls_that_return_are_never_interrupted(timer):  # law 15
    patience, looks = CallWatchdog(0.005), []
    look = patience._look
    signal.signal(signal.SIGALRM, lambda *given: (looks.append(None), look(*given)))
    while len(looks) < 5:
        patience.watch("flow0/brisk")
        patience.watch("")


def test_the_executive_itself_is_never_interrupted(timer):  # law 15
    patience, looks = CallWatchdog(0.005), []
    look = patience._look
    signal.signal(signal.SIGALRM, lambda *given: (looks.append(None), look(*given)))
    patience.watch("")
    while len(looks) < 5:
        pass
