"""What the language of applications has, as shipped applications show it: loops, choices, nesting, further targets."""

import json

import pytest

from kit.labs.laboratory import Laboratory, job, target
from kit.runtime.direct_client import OpenGate
from onika.cli import main
from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.program import RuntimeProgram
from onika.host.sessions.request_server import SessionRequest
from onika.host.units.virtual import VirtualDriver
from onika.link.caller import Role
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.wire import event, request, steer

pytestmark = pytest.mark.site

SYNTAX = open_site([], {}, None).syntax()[0]
BOXES = open_site([], {}, None).at(shipped() / "boxes").directories[0]
WAVE = ["opengripC", "closegripC", "pauseC half_second", "repeatC three"]
GRASP = ["opengripC", "jmoveC box2_aj", "cmoveC box2_bx", "closegripC", "holdsC"]
BACK = ["jmoveC box2_aj", "cmoveC box2_bx", "opengripC", "jmoveC box2_aj"]
FINGERS = ["opengripC", "closegripC"]


def done_by(capsys, name, *words):
    """The actions that were carried out, flow by flow."""
    code = main(["run", str(name), "--json", *(words or ["--virtual"])])
    events = [json.loads(line) for line in capsys.readouterr().out.splitlines() if line.startswith("{")]
    assert (code, events[-1]["state"]) == (0, "completed"), events[-1]
    began = [entry for entry in events if entry["event"] == "began"]
    flows = sorted({entry["flow"] for entry in began})
    return [[entry["action"] for entry in began if entry["flow"] == flow] for flow in flows]


@pytest.mark.parametrize("time", ["--virtual", "--no-fifo"])
def test_a_loop_is_gone_through_as_often_as_its_target_says(capsys, time):  # R-E05, R-D13
    assert done_by(capsys, "wave_three", time) == [WAVE * 3]


def test_a_loop_that_is_tested_first_goes_on_as_long_as_its_test_says(capsys):  # R-E05
    (done,) = done_by(capsys, "let_go")
    assert done == [*GRASP, "opengripC", "holdsC", "jmoveC box2_aj", "jmoveC home"]


def test_the_return_value_of_the_action_before_chooses_the_flow_of_a_nested_application(capsys, tmp_path):  # R-D10
    (held,) = done_by(capsys, "try_to_grasp")
    assert held == [*GRASP, *BACK, "jmoveC home"]
    onikon = BOXES.onikon("put_back", SYNTAX)[0]
    icons = [job("opengripC"), job("closegripC"), job("holdsC"), job("put_back", onikon.type)]
    (empty,) = done_by(capsys, Laboratory(tmp_path).application("nothing_there", icons), "--virtual")
    assert empty == [*FINGERS, "holdsC", "opengripC", "jmoveC box2_aj"]


def test_the_target_of_a_nested_application_fills_its_holes(capsys):  # R-D09, R-E06
    (done,) = done_by(capsys, "visit_boxes")
    assert done == [
        *("jmoveC box2_aj", *FINGERS, "jmoveC box1_aj", *FINGERS, "jmoveC box3_aj", *FINGERS),
        "jmoveC home",
    ]


def test_a_nested_parallel_application_begins_its_other_flow_each_time(capsys):  # R-D13, R-E04
    own, other = done_by(capsys, "wave_together")
    assert own == ["jmoveC aside", *FINGERS, "jmoveC home", "repeatC three"] * 3
    assert other == ["jmove_rightC aside", "opengrip_rightC", "closegrip_rightC"] * 3


def test_branches_in_line_follow_a_return_value_or_a_variable(capsys):  # R-D13
    assert done_by(capsys, "in_line") == [["opengripC", "noop", "widerC halfway", "closegripC", "jmoveC home"]]
    assert done_by(capsys, "see_the_lamp") == [["lamp_litC", "jmoveC aside", "jmoveC home"]]


def test_a_job_takes_two_targets(capsys):  # R-D13
    assert done_by(capsys, "by_way_of") == [["jmove_viaC aside box2_aj", "jmoveC home"]]


def test_two_targets_of_which_one_is_out_of_reach_are_refused_before_anything_moves(capsys, tmp_path):  # R-E01, law 26
    way = BOXES.onikon("aside", SYNTAX)[0]
    near = target("aside", way.type, *(" ".join(map(repr, item)) for item in way.values))
    far = target("far", way.type, "0 0 9 0 0 0", "1.0")
    two = job("jmove_viaC", "Joint job").replace("DESC", "TARGET      Joint object\nDESC", 1)
    for name, aims, said_of in (("via", (far, near), "far aside"), ("endpoint", (near, far), "aside far")):
        path = Laboratory(tmp_path).application(name, [two, *aims])
        path.write_text(path.read_text().replace("VERSION     1.3", "VERSION     2.0"))
        assert main(["run", str(path), "--virtual", "--json"]) == 2
        output = capsys.readouterr().out
        assert f"{said_of}: joint 3 at 9.00 rad is beyond 3.93" in output
        assert '"began"' not in output


def test_an_endless_loop_goes_on_until_somebody_leaves_it():  # R-D11, R-E05, R-E07
    planned = prepare_run("wave_on", open_site([], {}, None))
    server = OpenGate()
    driver = VirtualDriver(("rt0",), server.tell)
    driver.offer(planned.plan.worlds)
    program = RuntimeProgram(server, driver, ModuleFacts(), ("rt0",))
    program.applications.take("me", prepare(planned.plan, planned.targets, ModuleFacts()))
    program.applications.begin("me", request.Begin())
    while [message.index for message in server.events if isinstance(message, event.Began)].count(0) < 3:
        program.advance(0)
    server.waiting.append(SessionRequest(1, "me", Role.OWNER, steer.Leave("flow0")))
    program.serve()
    while program.advance(1_000_000_000):
        pass
    assert server.replies[1] == request.Done()
    result = server.events[-1]
    assert (result.completed, str(result.cause)) == (True, "")
    assert [message.action for message in server.events if isinstance(message, event.Began)] == [
        "jmoveC aside",
        "jmoveC home",
        "noop",
    ] * 3
