from kit.runtime.live_edits import COUNTER, live_edits_with_tasks
from onika.runtime import command
from onika.wire import live


def test_a_hand_spawns_turns_and_sees():
    hand = live_edits_with_tasks()
    assert hand.change(spawn=["counter"], on=["counter"]) == ""
    hand.let_pass(1.0)
    assert hand.states == {"counter": "ON"}
    assert hand.values("COUNT") == {"COUNT": 51.0}
    assert hand.cycles("counter") == 51


def test_a_lost_unit_is_silent_deaf_and_empty():
    hand = live_edits_with_tasks(("rt0", "rt1"), counter="rt1")
    hand.change(spawn=["counter", "source"], on=["counter", "source"])
    hand.driver.lose("rt1")
    hand.work()
    count = len(hand.driver.news)
    hand.driver.send("rt1", command.Report())
    hand.work()
    assert len(hand.driver.news) == count
    assert list(hand.driver.living()) == [("s0", "source")]


def test_a_unit_is_lost_after_so_many_words():
    hand = live_edits_with_tasks()
    hand.task("second", COUNTER.replace("COUNT", "SECOND"))
    hand.driver.fatal = (1, "rt0")
    hand.asker.send(hand.order(("counter", "second")))
    hand.work()
    assert hand.driver.gone == {"rt0"}
    assert len(hand.driver.news) == 1


def test_outcomes_are_found_by_number():
    hand = live_edits_with_tasks()
    answer = hand.asker.ask(hand.order(("counter",)))
    assert answer == live.Accepted(1)
    hand.work()
    assert hand.edited(1) == [""]
    assert hand.edited(2) == []
