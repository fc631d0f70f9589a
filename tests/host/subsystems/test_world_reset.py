import pytest

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.runtime.live_edits import LiveEdits
from kit.worlds.mass_world import MassWorld
from kit.worlds.rail_world import MASS, SERVO, rail_tasks
from kit.worlds.resettable_masses import ResettableMasses
from onika.ring.displacement import Displacement
from onika.wire import live, request
from onika.words.reason import Reason


@pytest.fixture
def hand():
    """A mass on its rail, and a servo that drives it; the mass has been driven to 1 m and stands there."""
    hand = LiveEdits()
    worlds = {"yard": ResettableMasses(), "cell": MassWorld()}
    hand.driver._buses._open = worlds.__getitem__
    hand.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"})
    hand.task("servo", SERVO)
    hand.worlds = worlds
    return hand


def driven(hand):
    hand.change(spawn=["mass", "servo"], on=["mass", live.Turn("servo", "1.0")])
    hand.let_pass(8.0)


def test_what_stands_elsewhere_is_surveyed_and_put_back_where_nothing_drives_it(hand):  # law 18
    driven(hand)
    hand.change(off=["mass"])
    assert hand.asker.ask(live.Survey()).displaced == {"yard": (Displacement(Reason.plain("m0 is away")),)}
    assert hand.asker.ask(live.PutBack()) == live.WorldsPutBack(("yard",))
    assert hand.asker.ask(live.Survey()).displaced == {"yard": ()}
    assert hand.worlds["yard"].state("m0")[2] == 0.0


def test_what_a_task_drives_is_not_put_back_and_the_task_is_named(hand):  # law 18, 27
    driven(hand)
    refused = hand.asker.ask(live.PutBack())
    assert refused == request.Refused(Reason.of("host.put_back_on", subsystem="s0", tasks=("mass",)))
    assert hand.worlds["yard"].state("m0")[2] > 0.5
    assert hand.asker.ask(live.PutBack(("cell",))) == live.WorldsPutBack(())


def test_what_another_session_holds_is_not_put_back(hand):  # law 27
    driven(hand)
    hand.change(off=["mass"])
    refused = hand.asker.ask(live.PutBack(), "other")
    assert refused == request.Refused(Reason.of("host.put_back_held", subsystem="s0", holder="me"))


def test_of_a_world_that_nobody_can_move_it_is_said_while_others_are_put_back(hand):  # law 18
    driven(hand)
    hand.change(off=["mass"])
    hand.driver.grant("rt0", "cell:m1")
    by_hand = Reason.of("runtime.put_all_back_by_hand", world="cell")
    assert hand.asker.ask(live.PutBack()) == live.WorldsPutBack(("yard",), {"cell": by_hand})


def test_nothing_is_put_back_under_an_application_and_nothing_is_surveyed_then():  # law 18
    desk = DirectClient()
    desk.ask(request.Prepare(rail_tasks().plan([action("mass", "servo", arguments="1.0")]), ()))
    desk.ask(request.Begin())
    desk.program.advance(0)
    refused = desk.ask(live.PutBack())
    assert (type(refused), refused.reason.key) == (request.Refused, "host.put_back_runs")
    assert desk.ask(live.Survey()).displaced == {}
    assert desk.to_the_end().completed
    assert desk.ask(live.PutBack()).by_hand.keys() == {"yard"}
    assert desk.ask(live.Survey()).displaced == {"yard": ()}
