from kit.link.event_scheduler import EventScheduler

MS = 1_000_000


def test_things_happen_in_their_order_and_none_after_the_end():
    time, seen = EventScheduler(1), []
    time.at(5, lambda: seen.append(("five", time.now_ns)))
    time.after(2, lambda: seen.append(("two", time.now_ns)))
    time.at(5, lambda: seen.append(("five again", time.now_ns)))
    time.at(9, lambda: seen.append(("never", time.now_ns)))
    while time.step(8):
        pass
    assert seen == [("two", 2), ("five", 5), ("five again", 5)]


def test_who_wants_to_be_served_often_is_served_once_at_the_earliest_wish():
    time, served = EventScheduler(1), []
    for due_ns in (7 * MS, 3 * MS, 5 * MS, None):
        time.wake("me", due_ns, lambda: served.append(time.now_ns))
    while time.step(20 * MS):
        pass
    assert served == [3 * MS]


def test_the_same_seed_gives_the_same_times():
    assert EventScheduler(4).uniform(1, 100) == EventScheduler(4).uniform(1, 100)
    assert all(MS <= EventScheduler(seed).uniform(1, 2) < 2 * MS for seed in range(20))
