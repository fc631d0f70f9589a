from onika.engine.clock_estimate import DRIFT_PPM, WINDOW_NS, ClockEstimate

MS = 1_000_000
S = 1_000 * MS
AHEAD = 1_000 * S
DRIFT = WINDOW_NS * DRIFT_PPM // 1_000_000


def exchange(estimate, at_ns, out_ns, back_ns):
    """One datagram of each direction, sent at the same time; the other clock is ahead."""
    estimate.went(at_ns, at_ns + out_ns + AHEAD, at_ns + back_ns)
    estimate.came(at_ns + AHEAD, at_ns + back_ns)


def test_nothing_is_learned_of_a_clock_before_datagrams_went_both_ways():
    estimate = ClockEstimate()
    assert (estimate.here(5, 0), estimate.trip_ns(0), estimate.bound_ns(0)) == (None, None, None)
    estimate.came(AHEAD, MS)
    assert estimate.here(5, MS) is None
    estimate.went(0, AHEAD + MS, MS)
    assert estimate.here(AHEAD + 7, MS) == 7


def test_the_quickest_of_each_direction_counts_though_they_are_not_of_one_exchange():
    estimate = ClockEstimate()
    exchange(estimate, 1 * S, 100 * MS, 180 * MS)
    exchange(estimate, 2 * S, 190 * MS, 100 * MS)
    exchange(estimate, 3 * S, 150 * MS, 150 * MS)
    assert estimate.here(AHEAD + 7 * S, 4 * S) == 7 * S
    assert estimate.trip_ns(4 * S) == 200 * MS
    assert estimate.bound_ns(4 * S) == 100 * MS + DRIFT


def test_a_lopsided_way_is_not_seen_and_the_error_is_within_the_bound():
    estimate = ClockEstimate()
    exchange(estimate, 1 * S, 120 * MS, 80 * MS)
    error_ns = abs(estimate.here(AHEAD, 2 * S))
    assert error_ns == 20 * MS <= estimate.bound_ns(2 * S)


def test_what_is_older_than_ten_seconds_counts_no_more():
    estimate = ClockEstimate()
    exchange(estimate, 1 * S, MS, MS)
    exchange(estimate, 8 * S, 5 * MS, 5 * MS)
    assert estimate.trip_ns(1 * S + MS + WINDOW_NS) == 2 * MS
    assert estimate.trip_ns(1 * S + MS + WINDOW_NS + 1) == 10 * MS
    assert estimate.trip_ns(8 * S + 5 * MS + WINDOW_NS + 1) is None


def test_a_round_trip_takes_no_negative_time():
    estimate = ClockEstimate()
    exchange(estimate, 0, -3, 1)
    assert estimate.trip_ns(S) == 0
