from onika.process.standing_clock import StandingClock


def test_no_time_passes_while_a_clock_stands():
    wall = [1000]
    clock = StandingClock(lambda: wall[0])
    clock.stand()
    wall[0] = 5000
    assert clock() == 1000
    clock.go_on(passed_ns=30)
    assert clock() == 1030
    wall[0] = 5100
    assert clock() == 1130


def test_a_clock_that_stood_for_a_moment_does_not_run_ahead():
    wall = [0]
    clock = StandingClock(lambda: wall[0])
    clock.stand()
    wall[0] = 10
    clock.go_on(passed_ns=50)
    clock.go_on(passed_ns=50)
    assert clock() == 10
