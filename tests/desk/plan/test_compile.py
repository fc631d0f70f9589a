from hashlib import sha256

import pytest

from kit.labs.laboratory import HOLE, Laboratory, job, joints
from onika.desk.plan.compile import Compiler, rtpus_of
from onika.store.program import load
from onika.store.site import open_site
from onika.wire.plan import Plan
from onika.words.fault import Place
from onika.words.reason import Reason

SOURCE = "from onika.module import Module\nclass Wink(Module):\n    trigger = True\n"


@pytest.fixture
def laboratory(tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.module("wink", SOURCE)
    laboratory.plain_task("wink", reads="X", writes="Y", hz=50, local="GAIN 2 3\n")
    laboratory.module("blink", SOURCE)
    laboratory.plain_task("blink")
    laboratory.configuration("winkC", "wink 100 rt1", "blink 20")
    laboratory.configuration("blinkC", "blink 0 rt0", "wink 50 rt7")
    return laboratory


def compiled(path):
    site = open_site([path.parent.parent], {}, None)
    syntax, _ = site.syntax()
    program, _ = load(path, site, syntax)
    compiler = Compiler(program, syntax, Place("twice.appl"), {"wink": "/lab/wink.rmod"})
    return compiler, compiler.plan()


def test_a_task_is_planned_as_its_rmod_describes_it(laboratory):  # law 23
    _, plan = compiled(laboratory.application("twice", [job("winkC")]))
    (flow,) = plan.flows
    wink, blink = flow.tasks
    assert (plan.application, flow.subsystem) == ("twice", "flow0")
    assert (wink.name, wink.module, wink.place, wink.rtpu, wink.frequency) == (
        "wink",
        "wink",
        "/lab/wink.rmod",
        "rt1",
        50,
    )
    assert (wink.invar, wink.outvar, wink.local, wink.type) == (("X",), ("Y",), (("GAIN", ("2", "3")),), "periodic")
    assert (blink.place, blink.rtpu) == ("blink", "unknown")


def test_code_is_named_by_its_content_and_goes_along_once(laboratory):  # reading 7, law 23
    _, plan = compiled(laboratory.application("twice", [job("winkC"), job("blinkC")]))
    digest = sha256(SOURCE.encode()).hexdigest()
    assert [(code.module, code.digest, code.source) for code in plan.code] == [
        ("blink", digest, SOURCE),
        ("wink", digest, SOURCE),
    ]
    assert {task.digest for task in plan.flows[0].tasks} == {digest}


def test_the_first_configuration_gives_the_unit_and_each_its_rates(laboratory):  # reading 13
    _, plan = compiled(laboratory.application("twice", [job("winkC"), job("blinkC")]))
    assert {task.name: task.rtpu for task in plan.flows[0].tasks} == {"wink": "rt1", "blink": "unknown"}
    first, second = plan.flows[0].actions
    assert (first.tasks, first.rates) == (("wink", "blink"), (("wink", 100.0), ("blink", 20.0)))
    assert (second.tasks, second.rates) == (("blink", "wink"), (("wink", 50.0),))  # 0 Hz: as the task itself says


def test_the_rate_of_a_configuration_overrides_that_of_the_task(laboratory):  # reading 10
    laboratory.plain_task("wink", hz=40)
    _, plan = compiled(laboratory.application("twice", [job("winkC")]))
    (wink,) = (task for task in plan.flows[0].tasks if task.name == "wink")
    assert (wink.frequency, dict(plan.flows[0].actions[0].rates)["wink"]) == (40.0, 100.0)


def test_a_job_and_its_target_are_one_action_with_an_argument_line(laboratory):  # R-E03
    flow = [job("winkC", "Joint job", "SYNCHTAG    meet"), joints("there", 1.0, -2.5, 3.0, 0.0, 0.0, 6.0, duration=4.0)]
    compiler, plan = compiled(laboratory.application("twice", [job("blinkC"), *flow]))
    action = plan.flows[0].actions[1]
    assert (action.name, action.job, action.target) == ("winkC there", "winkC", "there")
    assert action.arguments == "1.0 -2.5 3.0 0.0 0.0 6.0 4.0"
    assert (action.place, action.line, action.synch_tag) == ("twice.appl", 45, "meet")
    (target,) = compiler.targets
    assert (target.flow, target.action, target.kind) == (0, 1, "joint object")
    assert target.values == (1.0, -2.5, 3.0, 0.0, 0.0, 6.0, 4.0)


def test_only_a_parallel_application_has_several_flows(laboratory):  # R-E04, R-D10
    flows = [job("winkC")], [job("blinkC")]
    assert len(compiled(laboratory.application("twice", *flows, parallel=True))[1].flows) == 2
    assert len(compiled(laboratory.application("twice", *flows))[1].flows) == 1


def test_no_ops_have_no_tasks_and_what_is_missing_is_said_to_be(laboratory):  # R-D11
    flow = [job("noop", "Complete NOP"), job("nowhereC"), HOLE, job("winkC")]
    compiler, plan = compiled(laboratory.application("twice", flow))
    facts = [(action.name, action.is_noop, action.lacks_tasks, bool(action.tasks)) for action in plan.flows[0].actions]
    assert facts == [("noop", True, False, False), ("nowhereC", False, True, False), ("winkC", False, False, True)]
    assert compiler.faults == []


def test_a_module_without_code_is_a_fault_and_the_rest_is_compiled(laboratory):  # R-E01
    (laboratory.path / "module" / "wink.py").unlink()
    compiler, plan = compiled(laboratory.application("twice", [job("winkC")]))
    (fault,) = compiler.faults
    assert (str(fault.place), fault.reason) == ("/lab/wink.rmod", Reason.of("desk.code_missing", module="wink"))
    assert [task.name for task in plan.flows[0].tasks] == ["blink"]


def test_code_that_is_no_text_is_a_fault(laboratory):  # R-B07
    (laboratory.path / "module" / "wink.py").write_bytes(b"\xff\xfe")
    compiler, _ = compiled(laboratory.application("twice", [job("winkC")]))
    assert [fault.place.file.rpartition("/")[2] for fault in compiler.faults] == ["wink.py"]


def test_the_units_of_a_plan_are_those_it_names(laboratory):  # R-A15, reading 12
    _, plan = compiled(laboratory.application("twice", [job("winkC")], [job("blinkC")], parallel=True))
    assert rtpus_of(plan) == ("rt0", "rt1", "rt7")
    assert rtpus_of(Plan("none", (), ())) == ("rt0",)


def test_every_action_says_where_it_stands_from_the_outermost_application_inwards(laboratory):  # R-E11
    laboratory.application("inner", [job("winkC"), job("blinkC")])
    _, plan = compiled(laboratory.application("outer", [job("winkC"), job("inner", "Complete application")]))
    actions = plan.flows[0].actions
    assert [len(action.spot) for action in actions] == [1, 2, 2]
    assert actions[0].spot == (actions[0].line,)
    assert [action.spot[1] for action in actions[1:]] == [action.line for action in actions[1:]]
    assert actions[1].spot[0] == actions[2].spot[0] > actions[0].line
