"""What is asked by hand is answered at once, and what is none of it is left to others."""

from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.wire import holding, live, request
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason


def test_what_nobody_asks_by_hand_is_left_to_others():
    hands = DirectClient().program._hands
    assert hands.answer("me", live.Survey()) is None
    assert hands.answer("me", request.Snapshot()) is None


def test_a_change_takes_the_subsystem_for_who_asks():  # law 27
    desk, shop = DirectClient(), rail_tasks()
    change = live.Change("s0", spawn=(shop.planned("servo"),), code=(shop.code("servo"),))
    assert isinstance(desk.ask(change, "first"), live.Accepted)
    assert "held by first" in str(desk.ask(live.Take("s0"), "second").reason)


def test_a_change_whose_world_is_open_and_made_of_other_files_is_refused(monkeypatch):  # R-X19
    desk = DirectClient()
    wrong = Fault(Place("yard"), Reason.of("host.world_of_other_files", world="yard"), NOT_RUN)
    monkeypatch.setattr(desk.program._hands, "_offer", lambda _worlds: [wrong])
    assert [fault.reason for fault in desk.ask(live.Change("s0"), "first").faults] == [wrong.reason]


def test_a_part_that_is_not_there_is_not_touched():
    answer = DirectClient().ask(live.Touch("nowhere", "box", 1.0))
    assert isinstance(answer, request.Refused)


def test_holders_are_asked_of_the_authority():  # law 27
    desk = DirectClient()
    assert isinstance(desk.ask(holding.Sessions(), "first"), holding.Company)
    assert isinstance(desk.ask(holding.Hand("s0", "nobody"), "first"), request.Refused)
