import pytest

from onika.host.leases import Leases

SECOND = 1_000_000_000


class Held:
    """Two holders; one whose lease ran out holds nothing any more."""

    def __init__(self):
        self.needed = {"one", "two"}
        self.lapsed = []

    def lapse(self, session, silent_ns, now):
        self.needed.discard(session)
        self.lapsed.append((session, silent_ns, now))


@pytest.fixture
def held():
    return Held()


def test_a_lease_ends_with_its_last_moment_and_only_once(held):  # R-X12
    silences = {"one": SECOND - 1, "two": 0}
    leases = Leases(held, silences.get, SECOND)
    assert leases.judge(7) == []
    silences["one"] = SECOND
    assert leases.judge(8) == ["one"]
    assert leases.judge(9) == []
    assert held.lapsed == [("one", SECOND, 8)]


def test_it_is_known_when_the_next_one_may_end(held):  # R-X12
    silences = {"one": 300, "two": 100}
    leases = Leases(held, silences.get, 1000)
    assert leases.due_ns() == 700
    silences["one"] = 2000
    assert leases.due_ns() == 0
    leases.judge(0)
    assert leases.due_ns() == 900
    held.needed.clear()
    assert leases.due_ns() is None


def test_whose_end_is_noticed_has_no_lease(held):  # R-X12
    leases = Leases(held, lambda session: None if session == "one" else 5000, 1000)
    assert leases.judge(0) == ["two"]


def test_without_a_length_there_is_none(held):  # law 15
    leases = Leases(held, lambda _session: 10**15, 0)
    assert leases.judge(0) == []
    assert leases.due_ns() is None
