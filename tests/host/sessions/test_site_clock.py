"""The clock by which bookings go."""

from onika.host.sessions.site_clock import SiteClock


class Clocks:
    """The machine's clock, and one that nobody sets."""

    def __init__(self):
        self.monotonic_s, self.ahead_s = 100.0, 1_000_000.0
        self.site = SiteClock(lambda: self.monotonic_s + self.ahead_s, lambda: round(self.monotonic_s * 1e9))


def test_it_goes_with_the_machines_clock():  # R-F09
    clocks = Clocks()
    clocks.monotonic_s += 5
    clocks.ahead_s += 0.4
    assert clocks.site.look(is_kept=False) == 0
    assert clocks.site.now_s() == 1_000_105.4


def test_a_clock_that_is_set_changes_no_time_that_runs_and_is_told_once():  # R-F09
    clocks = Clocks()
    clocks.ahead_s -= 3600
    assert clocks.site.look(is_kept=True) == -3600
    assert clocks.site.look(is_kept=True) == 0
    assert clocks.site.now_s() == 1_000_100.0
    assert clocks.site.look(is_kept=False) == 0
    assert clocks.site.now_s() == 1_000_100.0 - 3600, "afterwards it is as late as it is"


def test_a_clock_that_is_corrected_by_little_is_followed():  # R-F09
    clocks = Clocks()
    clocks.ahead_s += 0.7
    assert clocks.site.look(is_kept=True) == 0
    assert clocks.site.now_s() == 1_000_100.7
