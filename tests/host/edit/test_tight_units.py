import pytest

from kit.runtime.live_edits import BROKEN, COUNTER, SOURCE, USER, LiveEdits
from kit.worlds.rail_world import rail_tasks
from onika.wire import event, live


def tight_edits(*rtpus: str) -> LiveEdits:
    """A counter that cycles on the first unit, where there is no gap; a newcomer, and one that reads its constant."""
    hand = LiveEdits(rtpus)
    hand.driver.tight = {rtpus[0]}
    hand.task("counter", COUNTER, frequency=50.0, rtpu=rtpus[0])
    hand.task("source", SOURCE)
    hand.task("user", USER)
    hand.change(spawn=["counter"], on=["counter"])
    return hand


def rail_edits(*rtpus: str) -> LiveEdits:
    """A mass that is driven by a servo, both on the first unit, where there is no gap; and a newcomer."""
    hand = LiveEdits(rtpus)
    hand.shop = rail_tasks()
    hand.task("source", SOURCE, rtpu=rtpus[0])
    hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")])
    hand.driver.tight = {rtpus[0]}
    return hand


def warnings(hand: LiveEdits) -> list[str]:
    """What was told that changes nothing, by key."""
    return [warning.text.key for warning in hand.asker.of(event.Warned)]


def test_a_newcomer_without_a_gap_is_born_on_another_unit_where_it_names_none():  # law 21
    hand = tight_edits("rt0", "rt1")
    assert hand.change(spawn=["source"], on=["source"]) == ""
    assert (hand.states, hand.standing()["source"].rtpu) == ({"counter": "ON", "source": "ON"}, "rt1")
    assert warnings(hand) == ["host.spawned_elsewhere"]


def test_where_nothing_drives_a_device_it_is_born_at_once_and_who_reads_its_constants_too():  # law 21
    hand = tight_edits("rt0")
    assert hand.change(spawn=["user", "source"], on=["source", "user"]) == ""
    assert hand.states == {"counter": "ON", "user": "ON", "source": "ON"}
    assert warnings(hand) == ["host.spawned_at_once", "host.spawned_at_once"]


def test_a_newcomer_that_names_its_unit_is_born_there_at_once():  # law 21
    hand = tight_edits("rt0", "rt1")
    hand.task("fixed", SOURCE, rtpu="rt0")
    assert hand.change(spawn=["fixed"]) == ""
    assert hand.standing()["fixed"].rtpu == "rt0" and warnings(hand) == ["host.spawned_at_once"]


def test_what_is_wrong_with_it_counts_at_once_too():  # law 22
    hand = tight_edits("rt0")
    hand.task("broken", BROKEN)
    assert "no sensor" in hand.change(spawn=["broken"], on=["broken"])
    assert (hand.states, warnings(hand)) == ({"counter": "ON"}, [])


def test_beside_what_drives_a_device_it_is_refused_with_the_ways_out():  # law 21
    hand = rail_edits("rt0")
    assert "ways out: another processing unit" in hand.change(spawn=["source"])
    assert hand.states == {"mass": "ON", "servo": "ON"} and warnings(hand) == []


def test_a_device_that_is_driven_from_another_unit_counts_as_driven():  # law 21
    hand = LiveEdits(("rt0", "rt1"))
    hand.shop = rail_tasks(rtpu="rt1")
    hand.task("source", SOURCE, rtpu="rt1")
    hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "5.0")])
    hand.driver.tight = {"rt1"}
    assert "ways out" in hand.change(spawn=["source"])
    hand.change(off=("mass",))
    assert hand.change(spawn=["source"]) == "" and warnings(hand) == ["host.spawned_at_once"]


def test_a_device_of_another_subsystem_counts_as_driven_on_its_units_alone():  # law 21
    hand = LiveEdits(("rt0", "rt1"))
    hand.shop = rail_tasks(rtpu="rt0")
    hand.task("counter", COUNTER, frequency=50.0, rtpu="rt1")
    hand.task("near", SOURCE, rtpu="rt0")
    hand.task("far", SOURCE, rtpu="rt1")
    hand.outcome(hand.asker.ask(hand.order(("mass", "servo"), ("mass",), "s1")))
    hand.change(spawn=["counter"], on=["counter"])
    hand.driver.tight = {"rt0", "rt1"}
    assert "ways out" in hand.change(spawn=["near"])
    assert hand.change(spawn=["far"]) == "" and warnings(hand) == ["host.spawned_at_once"]


def test_in_a_moment_of_hold_it_is_born_and_who_was_on_is_on_again():  # law 21, law 22
    hand = rail_edits("rt0")
    hand.let_pass(0.2)
    assert hand.change(spawn=["source"], on=["source"], holds=True) == ""
    assert hand.states == {"mass": "ON", "servo": "ON", "source": "ON"}
    assert warnings(hand)[-1] == "host.spawned_in_hold"
    hand.let_pass(6.0)
    assert hand.states["servo"] == "OFF"  # it did its job, with the line it had
    assert hand.values("X")["X"][0] == pytest.approx(5.0, abs=0.5)


def test_what_goes_off_with_the_change_stays_off_after_a_moment_of_hold():  # law 22
    hand = rail_edits("rt0")
    assert hand.change(spawn=["source"], off=("servo",), holds=True) == ""
    assert hand.states == {"mass": "ON", "servo": "OFF", "source": "OFF"}


def test_a_moment_of_hold_that_helps_nothing_leaves_everything_on():  # law 22
    hand = rail_edits("rt0")
    hand.task("counter", COUNTER, frequency=50.0, rtpu="rt0")
    hand.driver.tight = set()
    hand.outcome(hand.asker.ask(hand.order(("counter",), ("counter",), "s1")))
    hand.driver.tight = {"rt0"}
    assert "ways out" in hand.change(spawn=["source"], holds=True)
    assert hand.states == {"mass": "ON", "servo": "ON"}


def test_code_without_a_gap_is_exchanged_at_once_where_nothing_drives_a_device():  # law 21, R-X15
    hand = tight_edits("rt0")
    hand.task("counter", COUNTER.replace("+ 1.0", "+ 10.0"), frequency=50.0, rtpu="rt0")
    before = hand.values("COUNT")["COUNT"]
    assert hand.swap("counter") == "" and warnings(hand) == ["host.swapped_at_once"]
    hand.let_pass(1.0)
    assert hand.values("COUNT")["COUNT"] >= before + 500.0


def test_code_beside_what_drives_a_device_is_exchanged_in_a_moment_of_hold_alone():  # law 21, R-X15
    hand = rail_edits("rt0")
    hand.driver.tight = set()
    hand.task("counter", COUNTER, frequency=50.0, rtpu="rt0")
    hand.change(spawn=["counter"], on=["counter"])
    hand.driver.tight = {"rt0"}
    hand.task("counter", COUNTER.replace("+ 1.0", "+ 10.0"), frequency=50.0, rtpu="rt0")
    assert "ways out" in hand.swap("counter")
    order = live.Swap("s0", "counter", hand.shop.code("counter"), holds=True)
    assert hand.outcome(hand.asker.ask(order)) == ""
    assert hand.states == {"mass": "ON", "servo": "ON", "counter": "ON"}
    assert warnings(hand)[-1] == "host.swapped_in_hold"
