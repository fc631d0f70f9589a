import os
import signal

import pytest

from onika.host.shutdown import ShutdownSignals


@pytest.fixture(autouse=True)
def as_before():
    kept = [(number, signal.getsignal(number)) for number in (signal.SIGTERM, signal.SIGINT)]
    yield
    for number, handler in kept:
        signal.signal(number, handler)


def test_a_wish_to_end_is_noted():
    ending = ShutdownSignals(is_launched=False)
    assert not ending.is_asked
    os.kill(os.getpid(), signal.SIGTERM)
    assert ending.is_asked


@pytest.mark.parametrize(("is_launched", "is_asked"), [(True, False), (False, True)])
def test_a_ctrl_c_is_the_launching_programs_to_answer(is_launched, is_asked):  # decision 11
    ending = ShutdownSignals(is_launched)
    os.kill(os.getpid(), signal.SIGINT)
    assert ending.is_asked is is_asked
