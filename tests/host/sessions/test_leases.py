import pytest

from onika.host.sessions.leases import Leases, SessionSilence

MS = 1_000_000
SECOND = 1000 * MS
STEADY = {"beats": 5, "beats_silent_ns": 0}


class Held:
    """Two holders; one whose lease ran out holds nothing any more."""

    def __init__(self):
        self.needed = {"one", "two"}
        self.lapsed = []

    def lapse(self, session, silent_ns, now):
        self.needed.discard(session)
        self.lapsed.append((session, silent_ns, now))


class Clock:
    now_ns = 0

    def __call__(self):
        return self.now_ns


@pytest.fixture
def held():
    return Held()


def leases_of(held, silences, length_ns=SECOND):
    """Leases that are told how long each is silent; the clock stands."""
    return Leases(
        held, lambda session: SessionSilence(silences[session]) if session in silences else None, length_ns, Clock()
    )


def test_a_lease_ends_with_its_last_moment_and_only_once(held):  # R-X12
    silences = {"one": SECOND - 1, "two": 0}
    leases = leases_of(held, silences)
    assert leases.judge(7) == []
    silences["one"] = SECOND
    assert leases.judge(8) == ["one"]
    assert leases.judge(9) == []
    assert held.lapsed == [("one", SECOND, 8)]


def test_it_is_known_when_the_next_one_may_end(held):  # R-X12
    silences = {"one": 300, "two": 100}
    leases = leases_of(held, silences, 1000)
    assert leases.due_ns() == 700
    silences["one"] = 2000
    assert leases.due_ns() == 0
    leases.judge(0)
    assert leases.due_ns() == 900
    held.needed.clear()
    assert leases.due_ns() is None


def test_whoever_is_needed_is_looked_after_often(held):  # R-X12
    assert leases_of(held, {"one": 0, "two": 0}).due_ns() == 50 * MS


def test_whose_end_is_noticed_has_no_lease(held):  # R-X12
    leases = leases_of(held, {"two": 5000}, 1000)
    assert leases.judge(0) == ["two"]
    assert (leases.of("one"), leases.of("two")) == (0, 1000)


def test_without_a_length_there_is_none(held):  # law 15
    leases = leases_of(held, {"one": 10**15, "two": 10**15}, 0)
    assert leases.judge(0) == []
    assert leases.due_ns() is None
    assert leases.of("one") == 0


@pytest.mark.parametrize(
    ("silences", "length_ns"),
    [
        (SessionSilence(0), 1000 * MS),
        (SessionSilence(0, 4, 0, 100), 1000 * MS),
        (SessionSilence(0, **STEADY, round_trip_us=19_999), 250 * MS),
        (SessionSilence(0, **STEADY, round_trip_us=20_000), 500 * MS),
        (SessionSilence(0, **STEADY, round_trip_us=90_000), 500 * MS),
        (SessionSilence(0, 999, 1000 * MS - 1, 100), 250 * MS),
        (SessionSilence(0, 999, 1000 * MS, 100), 1000 * MS),
        (SessionSilence(0, 999, 9000 * MS, 100), 1000 * MS),
    ],
    ids=[
        "over TCP",
        "not relied on yet",
        "short way",
        "long way",
        "very long way",
        "just through",
        "no more",
        "long gone",
    ],
)
def test_a_lease_follows_from_the_way_that_beats_take(held, silences, length_ns):  # network.md D4
    assert Leases(held, lambda _: silences, None, Clock()).of("one") == length_ns
    assert Leases(held, lambda _: silences, 700 * MS, Clock()).of("one") == 700 * MS


def test_who_beats_by_datagram_is_missed_after_a_quarter_of_a_second(held):  # R-X12
    held.needed = {"one"}
    silences = {"silent": 249 * MS}
    leases = Leases(held, lambda _: SessionSilence(silences["silent"], 99, silences["silent"], 100), None, Clock())
    assert leases.judge(0) == []
    silences["silent"] = 250 * MS
    assert leases.judge(0) == ["one"]


def test_silence_while_the_runtime_itself_stood_still_is_excused_once(held):  # R-X12
    held.needed = {"one"}
    clock = Clock()
    leases = Leases(held, lambda _: SessionSilence(clock.now_ns, 99, clock.now_ns, 100), None, clock)
    clock.now_ns = 400 * MS  # it was kept from looking: what lies in the sockets comes in a moment
    assert leases.judge(0) == []
    assert 0 < leases.due_ns() <= 50 * MS
    for _ in range(2):
        clock.now_ns += 40 * MS
        assert leases.judge(0) == [] or clock.now_ns > 470 * MS
    clock.now_ns = 5000 * MS  # nobody is excused for ever
    leases.judge(0)
    clock.now_ns += 50 * MS
    leases.judge(0)
    assert [session for session, _, _ in held.lapsed] == ["one"]


def test_silence_while_the_porter_stood_still_is_excused_once_too(held):  # R-X12
    held.needed = {"one"}
    clock, deaf = Clock(), {"ns": 0}
    leases = Leases(
        held, lambda _: SessionSilence(clock.now_ns, 99, clock.now_ns, 100), None, clock, lambda: deaf["ns"]
    )
    for _ in range(6):
        clock.now_ns += 50 * MS
        deaf["ns"] = max(0, clock.now_ns - 100 * MS)
        assert leases.judge(0) == []
        assert 0 < leases.due_ns() <= 50 * MS
    deaf["ns"] = 0  # it listens again, and nobody was there
    assert leases.judge(0) == ["one"]


def test_a_porter_that_never_listens_again_does_not_keep_a_holder(held):  # R-X12
    held.needed = {"one"}
    clock = Clock()
    leases = Leases(
        held, lambda _: SessionSilence(clock.now_ns, 99, clock.now_ns, 100), None, clock, lambda: 10 * SECOND
    )
    while not held.lapsed:
        clock.now_ns += 50 * MS
        leases.judge(0)
    assert clock.now_ns == 500 * MS


def test_who_says_nothing_of_beats_has_none():  # network.md D4
    assert SessionSilence(5) == SessionSilence(5, beats=0, beats_silent_ns=0, round_trip_us=-1)


class Silence:
    """A session that was heard last at an instant of the clock."""

    def __init__(self, held, begin_ns):
        held.needed = {"one"}
        self.clock = Clock()
        self.clock.now_ns = self.heard_ns = begin_ns
        self.leases = Leases(held, lambda _: SessionSilence(self.clock.now_ns - self.heard_ns), SECOND, self.clock)

    def look(self, now_ns):
        self.clock.now_ns = now_ns
        return self.leases.judge(0)

    def look_until(self, now_ns):
        """Look every 50 ms; at which of these instants the lease ended, or None."""
        while self.clock.now_ns < now_ns:
            if self.look(min(self.clock.now_ns + 50 * MS, now_ns)):
                return self.clock.now_ns
        return None


@pytest.mark.parametrize("begin_ns", [0, 10 * SECOND])
def test_a_lease_is_no_longer_for_being_looked_at_often(held, begin_ns):  # R-X12
    silence = Silence(held, begin_ns)
    assert silence.look_until(begin_ns + 980 * MS) is None
    assert silence.leases.due_ns() == 20 * MS
    assert silence.look_until(begin_ns + SECOND - 1) is None
    assert silence.look(begin_ns + SECOND) == ["one"]


@pytest.mark.parametrize("begin_ns", [0, 10 * SECOND])
def test_of_a_pause_of_the_runtime_all_but_two_looks_is_excused(held, begin_ns):  # R-X12
    silence = Silence(held, begin_ns)
    assert silence.look(begin_ns + 400 * MS) == []
    assert silence.look_until(begin_ns + 1280 * MS) is None
    assert silence.leases.due_ns() == 20 * MS
    assert silence.look_until(begin_ns + 1300 * MS - 1) is None
    assert silence.look(begin_ns + 1300 * MS) == ["one"]


@pytest.mark.parametrize("again_ns", [MS, 500 * MS])
def test_what_was_excused_of_one_silence_is_not_excused_of_the_next(held, again_ns):  # R-X12
    silence = Silence(held, 10 * SECOND)
    silence.look(10 * SECOND + 400 * MS)
    silence.look_until(10 * SECOND + 500 * MS)
    silence.heard_ns += again_ns
    assert silence.look_until(11 * SECOND + again_ns - 1) is None
    assert silence.look(11 * SECOND + again_ns) == ["one"]


def test_a_deaf_runtime_looks_again_soon(held):  # R-X12
    silences = {"one": 2 * SECOND, "two": 0}
    leases = Leases(held, lambda session: SessionSilence(silences[session]), SECOND, Clock(), lambda: 1)
    assert leases.due_ns() == 10 * MS


def test_pauses_of_one_silence_are_excused_together(held):  # R-X12
    silence = Silence(held, 10 * SECOND)
    assert silence.look(10 * SECOND + 300 * MS) == []
    assert silence.look(10 * SECOND + 600 * MS) == []
    assert silence.look_until(11 * SECOND + 400 * MS - 1) is None
    assert silence.look(11 * SECOND + 400 * MS) == ["one"]


def test_no_more_is_excused_of_a_silence_than_it_has_lasted(held):  # R-X12
    silence = Silence(held, 10 * SECOND)
    silence.heard_ns = 10 * SECOND + 390 * MS
    assert silence.look(10 * SECOND + 400 * MS) == []
    assert silence.look_until(11 * SECOND + 400 * MS - 1) is None
    assert silence.look(11 * SECOND + 400 * MS) == ["one"]
