import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.desk.environment.reconcile.runtime_loss import lost, with_quality
from onika.model.task import Task
from onika.wire import act, event, live, request
from onika.words.reason import Reason

TASKS = tuple(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b"))
CMU, SANDIA = "wss://cmu.example:7994", "wss://sandia.example:7994"


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


@pytest.fixture
def trio(duet):
    """Three stations, the first one connected by a configuration of its own."""
    duet.here = duet.connected("a")
    assert duet.do(act.AddStation(CMU, name="cmu")) == "cmu"
    assert duet.do(act.AddStation(SANDIA)) == "sandia"
    return duet


def gone(trio, station):
    trio.environment.become(lambda model: lost(model, Reason.plain("the cable")), station)


def test_runtimes_are_connected_beside_each_other_each_with_what_is_known_of_it(trio):  # R-F02, R-C18
    tree = trio.environment.tree
    assert tree.runtime.state == "linked" and list(tree.stations) == ["cmu", "sandia"]
    assert {name: (seen.state, seen.address) for name, seen in tree.stations.items()} == {
        "cmu": ("linked", CMU),
        "sandia": ("linked", SANDIA),
    }
    assert list(tree.stations["cmu"].sessions) == ["you"] and trio.environment.model.station == ""


def test_a_configuration_is_turned_on_at_its_station_and_nobody_elsewhere_hears_of_it(trio):  # R-F02, R-C18
    doc = trio.new("a")
    trio.do(act.Connect(doc, station="cmu"))
    trio.do(act.Toggle(doc, "a"))
    home = trio.document(doc).live.subsystem
    assert trio.state(doc, "a") == "ON" and trio.others["cmu"].lives[home]["a"].state.value == "ON"
    assert trio.state(trio.here, "a") == "OFF" and not trio.others["sandia"].lives
    assert trio.environment.tree.documents[doc].station == "cmu"


def test_subsystems_of_one_name_at_two_stations_are_two(trio):  # R-F02
    doc = trio.new("a", "b")
    trio.do(act.Connect(doc, station="cmu", subsystem="Untitled-1"))
    assert trio.document(trio.here).live.subsystem == trio.document(doc).live.subsystem == "Untitled-1"
    trio.do(act.Toggle(trio.here, "a"))
    assert (trio.state(trio.here, "a"), trio.state(doc, "a")) == ("ON", "OFF")
    trio.others["cmu"].tell(event.Held("Untitled-1", "anna#2"))
    trio.hear()
    documents = trio.environment.tree.documents
    assert (documents[doc].holder, documents[trio.here].holder) == ("anna#2", "you")


def test_a_change_of_a_library_reaches_the_stations_that_need_it(trio):  # R-F02, R-C18
    doc = trio.new("a")
    trio.do(act.Connect(doc, station="cmu"))
    trio.alias("a", "A", "OTHER")
    for runtime in (trio.runtime, trio.others["cmu"]):
        spawned = [message for message in runtime.asked if isinstance(message, live.Change) and message.spawn]
        assert len(spawned) == 2


def test_stop_reaches_all_at_once_and_allowing_motion_too(trio):  # law 27, R-F02
    trio.is_held_back = True
    trio.environment.do(act.Stop(), "me", lambda given: None)
    stops = [order.station for order in trio.orders if isinstance(order.asked, request.Stop)]
    assert stops == ["", "cmu", "sandia"]
    trio.is_held_back = False
    trio.pump()
    tree = trio.environment.tree
    assert tree.runtime.is_stopped and all(seen.is_stopped for seen in tree.stations.values())
    trio.do(act.Reset(station="cmu"))
    assert not trio.environment.tree.stations["cmu"].is_stopped and trio.environment.tree.runtime.is_stopped
    trio.do(act.Reset(is_everywhere=True))
    tree = trio.environment.tree
    assert not tree.runtime.is_stopped and not any(seen.is_stopped for seen in tree.stations.values())


def test_a_station_that_is_cut_is_named_by_stop_and_not_waited_for(trio):  # law 27, R-F02
    trio.environment.become(lambda model: with_quality(model, True, 200.0), "cmu")
    trio.environment.become(lambda model: with_quality(model, True, -1.0))
    given = []
    trio.is_held_back = True
    trio.environment.do(act.Stop(), "me", given.append)
    stop = {order.station: order for order in trio.orders if isinstance(order.asked, request.Stop)}
    assert set(stop) == {"", "cmu", "sandia"}
    trio.environment.replied(stop["sandia"], request.Done())
    assert "the first station" in str(given[0].value) and "cmu" in str(given[0].value)
    trio.environment.replied(stop["cmu"], request.Refused(Reason.plain("the cable")))
    assert str(trio.says[-1].text) == "cmu has not answered Stop: the cable"


def test_stop_works_where_the_first_station_has_no_runtime(duet):  # law 27, R-F02
    duet.do(act.AddStation(CMU, name="cmu"))
    assert duet.do(act.Stop()) is None and duet.others["cmu"].is_stopped


def test_a_station_that_is_lost_takes_nothing_of_the_others_along(trio):  # R-F02, R-E10
    doc = trio.new("a")
    trio.do(act.Connect(doc, station="cmu"))
    trio.do(act.Toggle(trio.here, "a"))
    gone(trio, "cmu")
    tree = trio.environment.tree
    assert tree.stations["cmu"].state == "lost" and str(tree.stations["cmu"].text) == "the cable"
    assert tree.documents[doc].connection == "lost" and tree.documents[doc].station == "cmu"
    assert (tree.documents[trio.here].connection, trio.state(trio.here, "a")) == ("live", "ON")
    assert tree.runtime.state == tree.stations["sandia"].state == "linked"
    trio.do(act.Connect(doc))
    assert trio.document(doc).station == "cmu" and trio.orders[-1].station == "cmu"
    assert [order.reach.url for order in trio.orders if order.reach][-1] == CMU


def test_a_station_is_connected_once_more_by_its_name(trio):  # R-F02
    gone(trio, "cmu")
    assert trio.do(act.AddStation(name="cmu")) == "cmu"
    assert trio.environment.tree.stations["cmu"].state == "linked"


def test_where_a_station_is_not_reached_all_else_is_as_before(trio):  # R-C18, R-F02
    trio.rebuffs = {live.Survey: request.Refused(Reason.plain("nobody is there"))}
    no = trio.answer(act.AddStation("wss://far.example")).no
    assert "far at wss://far.example:7994 is not reached: nobody is there" in str(no.reason)
    assert list(trio.environment.tree.stations) == ["cmu", "sandia"]
    no = trio.answer(act.AddStation("wss://far.example", keeps=True)).no
    assert trio.environment.tree.stations["far"].state == "lost"
    doc = trio.new("a")
    assert trio.answer(act.Connect(doc, url="wss://nowhere.example")).no
    assert "nowhere" not in trio.environment.tree.stations and trio.document(doc).station == ""
    trio.rebuffs = {}
    trio.do(act.Toggle(trio.here, "a"))


@pytest.mark.parametrize(
    ("command", "field", "why"),
    [
        (act.AddStation("http://cmu"), "url", "ws"),
        (act.AddStation("wss://cmu.example", name="here"), "name", "here"),
        (act.AddStation("wss://other.example", name="cmu"), "name", CMU),
        (act.AddStation(CMU, name="again"), "", "station cmu already"),
        (act.AddStation(name="nobody"), "", "no station"),
        (act.RemoveStation("nobody"), "", "no station"),
        (act.RemoveStation(""), "", "no station"),
        (act.Take(subsystem="main", station="nobody"), "", "no station"),
    ],
)
def test_what_names_no_station_of_its_own_is_refused(trio, command, field, why):  # R-X01
    no = trio.no(command)
    assert why in str(no.reason) and (not field or field in no.fields)


def test_a_station_with_tasks_that_live_is_left_when_it_is_confirmed(trio):  # R-F02
    doc = trio.new("a")
    trio.do(act.Connect(doc, station="cmu"))
    (leave,) = trio.no(act.RemoveStation("cmu")).remedies
    trio.do(leave.act)
    assert list(trio.environment.tree.stations) == ["sandia"]
    assert (trio.environment.tree.documents[doc].connection, trio.document(doc).station) == ("none", "")
    trio.environment.receive(event.Stopped(True, Reason.plain("late")), "cmu")
    assert list(trio.environment.tree.stations) == ["sandia"] and not trio.environment.tree.runtime.is_stopped


def test_a_station_that_is_left_while_it_is_reached_does_not_come_back(duet):  # R-F02
    duet.is_held_back = True
    duet.environment.do(act.AddStation(CMU, name="cmu"), "me", lambda given: None)
    duet.environment.do(act.RemoveStation("cmu"), "me", lambda given: None)
    duet.is_held_back = False
    duet.pump()
    assert not duet.environment.tree.stations


def test_remedies_of_a_refusal_at_a_station_are_acts_there(trio):  # R-F02, X01
    doc = trio.new("a")
    trio.do(act.Connect(doc, station="cmu"))
    trio.do(act.Stop())
    (allow,) = trio.no(act.Toggle(doc, "a")).remedies
    assert allow.act == act.Reset(station="cmu")
