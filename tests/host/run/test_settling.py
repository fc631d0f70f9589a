from types import SimpleNamespace

import pytest

from onika.host.run.settling import Settling
from onika.runtime import command

SECOND = 1_000_000_000


class Asked:
    """Units that note who was asked."""

    def __init__(self):
        self.sent = []

    def send(self, rtpu, order):
        assert order == command.Report()
        self.sent.append(rtpu)


def flow(*rtpus):
    return SimpleNamespace(members={f"task{n}": SimpleNamespace(rtpu=rtpu) for n, rtpu in enumerate(rtpus)})


@pytest.fixture
def units():
    return Asked()


@pytest.fixture
def settling(units):
    return Settling(0.5, {0: flow("rt1", "rt0"), 1: flow("rt0")}, units)


def test_it_lasts_as_long_as_was_asked_for(settling):  # R-E14
    assert (settling.wake_at(), settling.is_due(SECOND)) == (None, False)
    settling.begin(SECOND)
    assert settling.wake_at() == 3 * SECOND // 2
    assert [settling.is_due(now) for now in (SECOND, 3 * SECOND // 2)] == [False, True]


def test_every_unit_is_asked_once_and_the_last_answer_ends_it(settling, units):  # R-E14
    settling.begin(0)
    settling.ask()
    assert (units.sent, settling.wake_at()) == (["rt0", "rt1"], None)
    assert [settling.reported(rtpu) for rtpu in ("rt0", "rt0", "rt1", "rt1")] == [False, False, True, False]


def test_what_nobody_asked_for_ends_nothing(settling):
    assert not settling.reported("rt0")


def test_who_is_lost_is_not_waited_for(settling):  # R-E10
    settling.ask()
    settling.lost("rt1")
    assert settling.reported("rt0")


def test_a_run_that_is_given_up_does_not_settle(settling):  # R-E14
    settling.begin(0)
    settling.give_up()
    assert settling.wake_at() is None
    settling.ask()
    settling.give_up()
    assert [settling.reported(rtpu) for rtpu in ("rt0", "rt1")] == [False, False]


def test_where_there_are_no_tasks_nobody_is_waited_for(units):  # R-E14
    settling = Settling(0.5, {0: flow()}, units)
    assert not settling.ask()
    assert units.sent == []
