import pytest

from kit.desk.live_runtime import LiveRuntime
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.reconcile.runtime_loss import lost
from onika.wire import act, event, request
from onika.words.reason import Reason

CMU = "wss://cmu.example:7994"


@pytest.fixture
def play(tmp_path):
    play = RunFixture(tmp_path)
    play.others["cmu"] = LiveRuntime(("rt0",))
    play.do(act.AddStation(CMU, name="cmu"))
    return play


def test_an_application_is_carried_out_at_its_station_and_told_of_there(play):  # R-E12, R-F02
    doc = play.open([job("aC"), job("bC")])
    play.do(act.PlaceFlow(doc, "", "cmu"))
    assert play.environment.tree.applications[doc].stations == {"": "cmu"}
    play.run(doc)
    begun = [station for station in ("", "cmu") if request_at(play, station, request.Prepare)]
    assert begun == ["cmu"] and play.view.station == "cmu" and play.view.state == "running"
    play.environment.receive(event.Began(0, 0, 2, "aC", 1.0, run="flow0"), "")
    assert not play.view.steps  # another runtime's run of that name
    play.environment.receive(event.Began(0, 0, 2, "aC", 1.0, run="flow0"), "cmu")
    assert play.view.steps
    play.do(act.Steer("pause 0", doc))
    assert play.others["cmu"].asked and not any(type(asked).__name__ == "Pause" for asked in play.runtime.asked)
    play.environment.receive(event.Result(True, Reason.plain(""), 2, 2, 9.0, 0.0, {}, (), "", run="flow0"), "cmu")
    assert play.view.is_completed


def request_at(play, station, kind):
    return [order for order in play.orders if isinstance(order.asked, kind) and (order.station or "") == station]


def test_runs_at_two_stations_do_not_meet_in_one_subsystem(play):  # R-E12, R-F02, R-C18
    here, there = play.open([job("aC")]), play.open([job("aC")], name="other")
    play.run(here)
    play.do(act.PlaceFlow(there, "", "cmu"))
    play.run(there)  # both claim the device `arm`, of two robots
    assert {run.view.station: run.homes for run in play.environment.model.going} == {"": ("flow0",), "cmu": ("flow0",)}
    play.environment.receive(event.Result(True, Reason.plain(""), 1, 1, 9.0, 0.0, {}, (), "", run="flow0"), "cmu")
    assert {run.view.station for run in play.environment.model.going} == {""}


def test_a_station_that_is_lost_ends_the_runs_there_alone(play):  # R-E10, R-F02
    here, there = play.open([job("aC")]), play.open([job("aC")], name="other")
    play.run(here)
    play.do(act.PlaceFlow(there, "", "cmu"))
    play.run(there)
    play.environment.become(lambda model: lost(model, Reason.plain("the cable")), "cmu")
    assert [run.view.name for run in play.environment.model.going] == ["play"]


def test_a_flow_that_is_none_and_a_station_that_is_none_are_refused(play):  # R-X01
    doc = play.open([job("aC")])
    assert "flow7" in str(play.no(act.PlaceFlow(doc, "flow7", "cmu")).reason)
    assert "no station" in str(play.no(act.PlaceFlow(doc, "", "far")).reason)


def test_flows_come_back_where_their_station_is_left(play):  # R-F02
    doc = play.open([job("aC")])
    play.do(act.PlaceFlow(doc, "", "cmu"))
    play.do(act.RemoveStation("cmu"))
    assert play.environment.tree.applications[doc].stations == {}
