from dataclasses import replace

import pytest

from kit.desk.live_runtime import LiveRuntime
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.reconcile.runtime_loss import lost
from onika.desk.environment.run_recorder import RunRecorder
from onika.desk.joined import meeting_links
from onika.wire import act, event, request, steer
from onika.wire.rendezvous_link import LinkRuntimes
from onika.words.reason import Reason

CMU = "wss://cmu.example:7994"


@pytest.fixture
def play(tmp_path):
    play = RunFixture(tmp_path)
    play.others["cmu"] = LiveRuntime(("rt0",))
    play.do(act.AddStation(CMU, name="cmu"))
    return play


def request_at(play, station, kind):
    return [order for order in play.orders if isinstance(order.asked, kind) and (order.station or "") == station]


@pytest.fixture
def apart(play):
    """Two flows that have no tag in common, the second one at cmu."""
    play.doc = play.open([job("bC"), job("bC")], [job("cC")], parallel=True)
    play.do(act.PlaceFlow(play.doc, "flow1", "cmu"))
    return play


@pytest.fixture
def meeting(play, monkeypatch):
    """Two flows that wait for each other at a tag, the second one at cmu, whose name is not looked up."""
    monkeypatch.setattr(meeting_links, "_reached", lambda host, hosts: host)
    first = [job("aC", "Complete job", "SYNCHTAG meet"), job("aC")]
    play.doc = play.open(first, [job("bC", "Complete job", "SYNCHTAG meet")], parallel=True)
    play.do(act.PlaceFlow(play.doc, "flow1", "cmu"))
    return play


def asked_at(play, station, kind):
    return [order.asked for order in request_at(play, station, kind)]


def told(play, station, message):
    play.environment.receive(message, station)


def test_flows_without_a_common_tag_run_at_two_stations_in_one_account(apart):  # R-E12, R-F02
    apart.run(apart.doc)
    plans = {station: asked_at(apart, station, request.Prepare)[0].plan for station in ("", "cmu")}
    assert {station: [flow.subsystem for flow in plan.flows] for station, plan in plans.items()} == {
        "": ["flow0"],
        "cmu": ["flow1"],
    }
    assert [code.module for code in plans["cmu"].code] == ["c"]
    assert {name: flow.station for name, flow in apart.view.flows.items()} == {"flow0": "", "flow1": "cmu"}
    told(apart, "", event.Began(0, 0, 2, "bC", 1.0, run="flow0"))
    told(apart, "cmu", event.Began(0, 0, 1, "cC", 1.0, run="flow1"))
    assert len(apart.view.steps) == 2
    told(apart, "", event.Done(0, 0, 2.0, run="flow0"))
    told(apart, "cmu", event.Done(0, 0, 3.0, run="flow1"))
    told(apart, "cmu", event.Result(True, Reason.plain(""), 1, 1, 3.0, 0.0, {}, (), "", run="flow1"))
    assert apart.view.state == "running" and apart.view.done == 2
    told(apart, "", event.Result(True, Reason.plain(""), 2, 2, 4.0, 0.0, {}, (), "", run="flow0"))
    assert (apart.view.state, apart.view.is_completed, apart.view.done, apart.view.took_s) == ("over", True, 3, 4.0)


def test_each_flow_is_steered_where_it_is_and_all_of_them_everywhere(apart):  # R-E07, R-E12
    apart.run(apart.doc)
    apart.do(act.Steer("pause 1", apart.doc))
    assert asked_at(apart, "cmu", steer.Pause) == [steer.Pause("flow1")] and not asked_at(apart, "", steer.Pause)
    apart.do(act.Steer("pause", apart.doc))
    assert steer.Pause("flow0") in asked_at(apart, "", steer.Pause)
    apart.do(act.Steer("abort", apart.doc))
    assert [asked_at(apart, station, request.Abort)[0].subsystem for station in ("", "cmu")] == ["flow0", "flow1"]


def test_a_station_that_is_lost_ends_its_part_and_the_account_says_so(apart):  # R-E10, R-E12, R-F02
    apart.run(apart.doc)
    apart.environment.become(lambda model: lost(model, Reason.plain("the cable")), "cmu")
    assert apart.view.state == "running" and "cmu" in str(apart.view.notes[-1])
    told(apart, "", event.Result(True, Reason.plain(""), 2, 2, 4.0, 0.0, {}, (), "", run="flow0"))
    assert apart.view.state == "over" and not apart.view.is_completed
    assert "cmu" in str(apart.view.cause) and "the cable" in str(apart.view.cause)


def test_where_one_station_does_not_begin_what_has_begun_is_ended(apart):  # R-E12
    apart.rebuffs = {}
    apart.runtime.refusals, apart.others["cmu"].refusals = {}, {"Begin": Reason.plain("not now")}
    no = apart.answer(act.Run(apart.doc)).no
    assert "cmu: not now" in str(no.reason)
    assert asked_at(apart, "", request.Abort)[0].subsystem == "flow0" and not asked_at(apart, "cmu", request.Abort)
    assert apart.environment.tree.run is None


def test_what_is_in_the_way_at_a_station_is_told_and_nothing_begins(apart):  # R-E12
    doc = apart.new("c")
    apart.do(act.Connect(doc, station="cmu"))
    no = apart.answer(act.Run(apart.doc)).no
    assert "at cmu there is in the way" in str(no.reason) and not asked_at(apart, "", request.Prepare)


def test_a_run_at_several_stations_that_nobody_writes_down_does_not_begin(apart, tmp_path):  # R-X05
    apart.surroundings = replace(apart.surroundings, state=tmp_path / "state")
    no = apart.answer(act.Run(apart.doc, is_recorded=True)).no
    assert no.remedies[0].act == act.Run(apart.doc)
    assert not asked_at(apart, "", request.Begin)


def test_nothing_is_left_of_the_recording_of_a_run_that_does_not_begin(apart, tmp_path):  # R-X05
    recorder = RunRecorder()
    recorder.attend(apart.environment)
    apart.surroundings = replace(apart.surroundings, state=tmp_path / "state", recorder=recorder)
    apart.environment._surroundings = apart.surroundings
    apart.rebuffs = {}
    apart.runtime.refusals, apart.others["cmu"].refusals = {}, {"Begin": Reason.plain("not now")}
    assert "not now" in str(apart.answer(act.Run(apart.doc, is_recorded=True)).no.reason)
    assert list((tmp_path / "state").rglob("*.mcap")) == []


def test_flows_that_wait_for_each_other_at_two_stations_meet_by_themselves(meeting):  # R-E12, R-F02, law 28
    meeting.run(meeting.doc)
    here, there = (asked_at(meeting, station, LinkRuntimes)[0] for station in ("", "cmu"))
    assert (here.run, here.tags) == (there.run, there.tags)
    assert [tag.tag for tag in here.tags if tag.sites == (0, 1)] == [tag.tag for tag in here.tags]
    assert "meet" in [tag.tag for tag in here.tags] and len(here.tags) == 2  # and one at which all begin
    assert [(other.site, other.host) for other in here.partners] == [(1, "cmu.example")]
    assert [(other.site, other.title) for other in there.partners] == [(0, "the first station")]
    begins = [asked_at(meeting, station, request.Begin)[0] for station in ("", "cmu")]
    assert begins[0].meets == begins[1].meets and begins[0].meets.one_way_ns == 1_000_000
    assert "whoever begins alone is held after" in str(meeting.view.notes[-1])


def test_why_runtimes_do_not_meet_is_told_before_anything_begins(meeting):  # R-E12, law 28
    meeting.others["cmu"].refusals = {"OfferPact": Reason.of("host.wall_time_only")}
    no = meeting.answer(act.Run(meeting.doc)).no
    assert "cmu" in str(no.reason) and "wall time only" in str(no.reason)
    assert [remedy.act for remedy in no.remedies] == [
        act.PlaceFlow(meeting.doc, "", ""),
        act.PlaceFlow(meeting.doc, "", "cmu"),
    ]
    assert not asked_at(meeting, "", request.Begin) and meeting.environment.tree.run is None


def test_a_machine_that_others_cannot_reach_is_told(meeting, monkeypatch):  # R-E12
    def unreached(host, hosts):
        raise OSError(101, "no route")

    monkeypatch.setattr(meeting_links, "_reached", unreached)
    assert "Network is unreachable" in str(meeting.answer(act.Run(meeting.doc)).no.reason)
