import pytest

from onika.desk.environment.reconcile.loop_watchdog import EVERY_S, LIMIT_S, LoopWatchdog


class Loop:
    """A loop that does what is posted when the test lets it, and its clock."""

    def __init__(self):
        self.now_s, self.posted, self.back = 0.0, [], 0
        self.vouch = LoopWatchdog(self.posted.append, self._is_back, lambda: self.now_s)

    def _is_back(self):
        self.back += 1

    def turn(self):
        while self.posted:
            self.posted.pop()()


@pytest.fixture
def loop():
    return Loop()


def test_a_loop_that_answers_is_asked_again_after_a_while(loop):  # R-X12
    for _ in range(3):
        assert loop.vouch.ask() == EVERY_S
        assert len(loop.posted) == 1
        loop.turn()
        loop.vouch.ask()
        assert not loop.posted and not loop.vouch.is_missing
        loop.now_s += EVERY_S
    assert loop.back == 0


def test_one_that_does_not_answer_in_time_is_missing_until_it_does(loop):  # R-X12
    loop.vouch.ask()
    loop.now_s = LIMIT_S / 2
    assert loop.vouch.ask() == LIMIT_S / 2
    assert not loop.vouch.is_missing and len(loop.posted) == 1
    loop.now_s = LIMIT_S
    assert loop.vouch.is_missing and loop.vouch.ask() == 0.0
    loop.turn()
    assert not loop.vouch.is_missing and loop.back == 1
