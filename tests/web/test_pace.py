from onika.web.pace import Pace


def test_who_sends_as_people_do_never_waits():
    pace = Pace(at_once=10, a_second=5.0)
    assert [pace.wait_s(0.2 * number) for number in range(100)] == [0.0] * 100
    assert [Pace(10, 5.0).wait_s(3.0) for _ in range(10)] == [0.0] * 10


def test_who_floods_is_read_so_fast_and_no_faster():  # R-F10
    pace, now, count = Pace(at_once=10, a_second=5.0), 0.0, 0
    while now < 100.0:
        now += pace.wait_s(now)
        count += 1
    assert 500 <= count <= 515
