import random

from onika.host.units.early_wake import EarlyWake

LONG_NS = 2_000_000


def woken(early_wake, late_ns):
    for one in late_ns:
        early_wake.note(one)
    return early_wake.lead_ns(LONG_NS)


def test_who_was_never_woken_late_is_woken_when_it_is_time():
    assert EarlyWake().lead_ns(LONG_NS) == 0
    assert woken(EarlyWake(), [0] * 1000) < 4_000


def test_nearly_all_wake_ups_come_before_the_instant():
    drawn = random.Random(4)
    late_ns = [drawn.randint(20_000, 60_000) for _ in range(8000)]
    early_wake = EarlyWake()
    woken(early_wake, late_ns[:4000])
    within = 0
    for one in late_ns[4000:]:
        within += one <= early_wake.lead_ns(LONG_NS)
        early_wake.note(one)
    assert within / 4000 > 0.97


def test_a_few_very_late_ones_do_not_lengthen_the_way_that_is_waited_awake():
    assert woken(EarlyWake(), [30_000] * 500) < 40_000
    assert woken(EarlyWake(), ([30_000] * 499 + [5_000_000]) * 4) < 60_000


def test_whatever_the_system_does_a_twentieth_of_a_gap_and_a_tenth_of_a_millisecond_are_the_most():
    early_wake = EarlyWake()
    woken(early_wake, [10**9] * 1000)
    assert early_wake.lead_ns(10**9) == 100_000
    assert early_wake.lead_ns(200_000) == 10_000
