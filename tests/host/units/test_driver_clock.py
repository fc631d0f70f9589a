from onika.host.units.driver_clock import DriverClock
from onika.host.units.virtual import VirtualDriver


class Alarms:
    """A listener that has something to do at given times and hears no news."""

    is_moving = is_hurried = True
    is_still = False

    def __init__(self, *times_ns):
        self.times_ns = list(times_ns)

    def wake_at(self):
        return self.times_ns[0] if self.times_ns else None

    def tick(self, now):
        assert now == self.times_ns.pop(0)


def standing(clock: DriverClock):
    return clock.now, clock.turn


def test_turns_count_what_is_done_at_one_instant_and_begin_anew_with_the_next():  # law 14
    driver = VirtualDriver(("rt0",), lambda _event: None)
    instants = []
    driver.listen(Alarms(5, 5, 5, 9))
    driver.each_instant(lambda: instants.append(standing(driver)))
    while driver.advance(0):
        pass
    assert driver.is_virtual
    assert instants == [(5, 1), (5, 2), (5, 3), (9, 1)]
