"""A plan is looked at as a whole: everything that can be wrong is asked, and all that is answered is told."""

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.rail_world import YardLoading
from onika.host.loading import plan_preparation
from onika.host.loading.plan_checks import at_action
from onika.host.loading.plan_preparation import Preparation, inspect, prepare
from onika.host.loading.target_order import RELATIVE
from onika.host.loading.target_resolution import Resolution
from onika.wire.plan import Do, Halt, Rest
from onika.wire.request import TargetValues
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import NOTHING, Reason

ARM = """
from onika.module import InVar, Local, Module, OutConst, OutVar

class Arm(Module):
    hardware = True
    N = OutConst("int", "-", "number of joints")
    QMAX = OutConst("double[N]", "m", "how far")
    Q_REF = InVar("double[N]", "m", "where to")
    Q_MEZ = OutVar("double[N]", "m", "where it is")

    @classmethod
    def constants(cls, local, identity):
        return {"N": 2, "QMAX": [1.0, 1.0]}
"""
HAND = """
from onika.module import Module, OutVar

class Hand(Module):
    hardware = True
    GRIP = OutVar("double", "N", "how it grips")
"""
MOVE = """
from onika.module import InConst, Input, InVar, Module, OutVar, finish

class Move(Module):
    trigger = True
    N = InConst("int", "-", "number of joints")
    QMAX = InConst("double[N]", "m", "how far")
    Q_MEZ = InVar("double[N]", "m", "where it is")
    Q_REF = OutVar("double[N]", "m", "where to")
    end = Input("double[N]", "m", "where to", low=0.0, high="QMAX")

    def cycle(self):
        return finish()
"""
BELL = """
from onika.module import Module, finish

class Bell(Module):
    trigger = True

    def cycle(self):
        return finish()
"""
EYE = """
from onika.module import Module, OutVar

class Eye(Module):
    SEEN = OutVar("double", "-", "what it sees")
"""
REMARK, UNLIKE = Reason.plain("that is odd"), Reason.plain("it is another one")


class Loading(YardLoading):
    """Answers as it is told to, and remembers what it was asked."""

    def __init__(self, fits=NOTHING, company=(), of_flow=(), resolve=(), simulated=True):
        super().__init__()
        self._fits, self._company, self._of_flow, self._resolve = fits, company, of_flow, list(resolve)
        self._simulated = simulated
        self.expected = []
        self.loaded = []
        self.fitted = []
        self.resolved = []

    def expect(self, codes):
        self.expected.append(codes)

    def sheet(self, code):
        self.loaded.append(code.module)
        return super().sheet(code)

    def is_simulated(self, _world):
        return self._simulated

    def fits(self, code, constants, device):
        self.fitted.append((code.module, constants, device))
        return self._fits

    def company(self, _world, _devices, *, is_of_flow=False):
        return self._of_flow if is_of_flow else self._company

    def resolve(self, code, constants, targets):
        self.resolved.append((code.module, constants, targets))
        return self._resolve.pop(0) if self._resolve else [None] * len(targets)


@pytest.fixture
def shop():
    shop = PlanBuilder()
    shop.task("arm", ARM, local={"DEVICE": "yard:m0"}, frequency=500.0)
    shop.task("hand", HAND, local={"DEVICE": "yard:m1"}, frequency=500.0)
    shop.task("eye", EYE, local={"DEVICE": "yard:scale"})
    shop.task("move", MOVE)
    shop.task("bell", BELL)
    return shop


def prepared(plan, *targets, loading=None):
    return prepare(plan, targets, loading or Loading())


def reasons(preparation):
    return [fault.reason.key for fault in preparation.faults]


def test_of_a_plan_that_is_none_nothing_else_is_believed(shop):  # R-E01, law 24
    plan = replace(shop.plan([action("bell")], [action("bell")]), application="\0")
    loading = Loading()
    preparation = prepared(plan, loading=loading)
    assert preparation.faults
    assert loading.expected == []
    assert preparation == Preparation(plan, {code.digest: code for code in plan.code}, preparation.faults)
    assert (preparation.resolved, preparation.worlds, preparation.notes) == ([], {}, [])


def test_the_modules_of_a_plan_are_announced_and_those_that_nobody_uses_are_not_looked_at(shop):  # R-E01
    shop.task("bad", "class Bad(:\n")
    plan = shop.plan([action("bell")])
    plan = replace(plan, code=(*plan.code, shop.code("bad")))
    loading = Loading()
    assert prepared(plan, loading=loading).faults == []
    assert loading.expected == [plan.code]


def resting(plan, flow, condition):
    """The plan, with a breakpoint behind the first action of a flow."""
    program = (Do(0), Rest(0, condition), Halt())
    flows = [replace(each, program=program) if at == flow else each for at, each in enumerate(plan.flows)]
    return replace(plan, flows=tuple(flows))


def test_a_condition_on_a_variable_that_nobody_has_is_told(shop):  # R-D13
    plan = resting(shop.plan([action("arm", "bell")]), 0, "Q_MEZ[1] > 1")
    assert prepared(plan).faults == []
    assert len(prepared(resting(plan, 0, "Q_MEZ[2] > 1")).faults) == 1
    assert len(prepared(resting(plan, 0, "NOBODY > 1")).faults) == 1


def test_no_condition_is_judged_while_a_task_is_missing(shop):  # R-E01
    shop.task("bad", "class Bad(:\n")
    plan = resting(shop.plan([action("arm", "bell")], [action("bad", "bell")]), 1, "NOBODY > 1")
    assert [str(fault.place) for fault in prepared(plan).faults] == ["bad.py:1"]


def test_devices_are_looked_for_and_judged_together_over_all_flows(shop):  # laws 16, 18
    shop.task("far", HAND + "\n", module="far", local={"DEVICE": "yard:m7"}, frequency=500.0)
    plan = shop.plan([action("arm", "bell")], [action("hand", "bell")])
    assert reasons(prepared(plan, loading=Loading(company=(UNLIKE,)))) == ["host.devices_unfit"]
    assert prepared(plan).faults == []
    assert reasons(prepared(shop.plan([action("far", "bell")]))) == ["host.no_such_device"]


@pytest.mark.parametrize("is_simulated", [True, False])
def test_a_plan_says_of_its_worlds_whether_they_are_real(shop, is_simulated):  # R-E09
    loading = Loading(simulated=is_simulated)
    assert prepared(shop.plan([action("arm", "bell")]), loading=loading).worlds == {"yard": is_simulated}


def test_notes_stand_in_order_and_once(shop):  # R-X01
    odd = shop.task("odd", HAND + "\n", module="odd", local={"DEVICE": "yard:m0", "NOISE": "3"}, frequency=500.0)
    shop.task("ring", BELL + "\n", module="ring", local={"TONE": "3"})
    preparation = prepared(
        shop.plan([action("odd", "hand", "ring")], [action("ring")]), loading=Loading(of_flow=(REMARK,))
    )
    unknown = [
        Reason.of("host.note_in", file=place, note=Reason.of("host.parameter_unknown", name=name, module=module))
        for place, name, module in ((odd.place, "NOISE", "odd"), ("ring.rmod", "TONE", "ring"))
    ]
    assert preparation.notes == [*unknown, Reason.of("host.note_in", file="yard", note=REMARK)]


def test_what_is_missing_only_because_another_task_is_wrong_is_not_told(shop):  # R-E01
    shop.task("bad", "class Bad(:\n")
    shop.task("twin", BELL, module="bell")
    plan = shop.plan([action("bell", "twin")], [action("bad", "move")])
    assert [(str(fault.place), fault.reason.key) for fault in prepared(plan).faults][1:] == [
        ("twin.rmod", "host.module_twice")
    ]


def test_a_task_that_differs_from_its_module_counts_as_missing(shop):  # R-B01
    wrong = replace(shop.planned("arm"), outvar=("Q_MEZ", "ODD"))
    shop._tasks["arm"] = wrong
    preparation = prepared(shop.plan([action("arm", "bell")]))
    assert [wired.name for wired in preparation.flows[0]] == ["bell"]
    assert [str(fault.place) for fault in preparation.faults] == ["arm.rmod"]


def test_tasks_are_inspected_each_by_itself_with_all_that_is_wrong_and_odd(shop):  # R-E01, R-X01
    shop.task("bad", "class Bad(:\n")
    names = ("bad", "arm", "hand")
    tasks = [shop.planned("bad")]
    for name in names[1:]:
        task = shop.planned(name)
        tasks.append(replace(task, outvar=(*task.outvar, "ODD"), local=(*task.local, ("NOISE", ("3",)))))
    faults, notes = inspect(tasks, [shop.code(name) for name in names], Loading())
    assert [str(fault.place) for fault in faults] == ["arm.rmod", "bad.py:1", "hand.rmod"]
    assert [(note.args["file"], note.args["note"].args["name"]) for note in notes] == [
        ("arm.rmod", "NOISE"),
        ("hand.rmod", "NOISE"),
    ]


def test_tasks_that_are_none_are_not_inspected(shop):  # law 24
    loading = Loading()
    faults, notes = inspect([replace(shop.planned("bell"), name="\0")], [shop.code("bell")], loading)
    assert (bool(faults), notes, loading.loaded) == (True, [], [])
    assert faults == sorted(set(faults))


def with_actions(plan, **changes):
    """The plan, with its first action changed so."""
    flow = plan.flows[0]
    first, *others = flow.actions
    return replace(plan, flows=(replace(flow, actions=(replace(first, **changes), *others)), *plan.flows[1:]))


def test_what_does_nothing_needs_no_trigger_and_what_follows_is_looked_at(shop):  # R-D11, R-E03
    plan = with_actions(shop.plan([action("bell"), action("eye")]), is_noop=True, tasks=())
    preparation = prepared(plan)
    assert preparation.triggers == {(0, 0): None, (0, 1): None}
    assert [(fault.reason.key, fault.place.line) for fault in preparation.faults] == [("host.trigger_missing", 2)]


def test_a_trigger_is_not_missed_where_tasks_of_the_job_are(shop):  # R-E01
    shop.task("bad", "class Bad(:\n")
    assert reasons(prepared(with_actions(shop.plan([action("eye")]), lacks_tasks=True))) == []
    (fault,) = prepared(shop.plan([action("eye", "bad")])).faults
    assert str(fault.place) == "bad.py:1"


def test_one_trigger_is_no_word_worth_and_of_more_all_others_are_named(shop):  # reading 16
    for name in ("gong", "horn"):
        shop.task(name, f"# {name}\n{BELL}")
    assert prepared(shop.plan([action("bell")])).notes == []
    (note,) = prepared(shop.plan([action("bell", "gong", "horn")])).notes
    more = Reason.of("host.triggers_more", job="job0", trigger="bell", others="gong, horn")
    assert note == Reason.of("host.note_at", file="test.appl", line=1, note=more)


def test_a_task_without_a_rate_has_none_that_could_be_wrong(shop):  # R-A04
    shop.task("now", BELL + "\n", module="now", frequency=None)
    shop.task("fast", EYE + "\n", module="fast", frequency=1e9)
    (fault,) = prepared(shop.plan([action("now", "fast")])).faults
    assert (str(fault.place), fault.instead) == ("fast.rmod", NOT_RUN)


def test_whoever_has_a_device_is_asked_whether_it_is_the_one_that_is_meant(shop):  # law 16, R-K05
    loading = Loading(fits=UNLIKE)
    preparation = prepared(shop.plan([action("eye", "arm", "hand", "bell")]), loading=loading)
    assert loading.fitted == [
        ("eye", {}, "yard:scale"),
        ("arm", {"N": 2, "QMAX": [1.0, 1.0]}, "yard:m0"),
        ("hand", {}, "yard:m1"),
    ]
    assert reasons(preparation) == ["host.device_unlike"] * 3


def test_constants_of_all_robots_count_by_the_names_that_they_have_here(shop):  # law 26
    second = ARM.replace('"N": 2', '"M": 3').replace("N =", "M =").replace("[N]", "[M]").replace("QMAX", "QMOST")
    shop.task(
        "other", second, local={"DEVICE": "yard:m1"}, frequency=500.0,
        aliases={"M": "NDOF", "Q_REF": "P_REF", "Q_MEZ": "P_MEZ"},
    )  # fmt: skip
    shop.task("mute", ARM.replace("return {", "return 1 / 0, {"), local={"DEVICE": "yard:m0"}, frequency=500.0,
              aliases={"N": "K", "QMAX": "KMAX", "Q_REF": "R_REF", "Q_MEZ": "R_MEZ"})  # fmt: skip
    preparation = prepared(shop.plan([action("mute", "arm", "other", "bell")]))
    assert preparation.constants == {0: {"N": 2, "QMAX": [1.0, 1.0], "NDOF": 3, "QMOST": [1.0, 1.0]}}


def test_reach_is_asked_of_robots_for_what_they_do_and_for_nothing_else(shop):  # law 26, R-X02
    flow = [
        action("arm", "move", arguments="0.1 0.2"),
        action("hand", "bell"),
        action("arm", "bell", arguments="1 2 3"),
        action("arm", "move", arguments="0.1"),
        action("arm", "move"),
        action("arm", "eye"),
    ]
    targets = [TargetValues(0, at, "joint object", (float(at),)) for at in range(6)]
    loading = Loading()
    prepared(shop.plan(flow), *targets, loading=loading)
    judged = [("joint object", [at]) for at in (0.0, 4.0, 5.0)]
    assert loading.resolved == [("arm", {"N": 2, "QMAX": [1.0, 1.0]}, judged)]


def test_a_trigger_without_a_line_asks_when_its_turn_comes(shop):  # R-A10, R-E03
    assert prepared(shop.plan([action("arm", "move")])).faults == []


def test_a_line_with_too_few_values_is_told_for_that_alone(shop):  # R-E03
    plan = shop.plan([action("arm", "move", arguments="0.1")])
    loading = Loading()
    preparation = prepared(plan, TargetValues(0, 0, "joint object", (9.0,)), loading=loading)
    assert reasons(preparation) == ["host.values_unfit"]
    assert [targets for _, _, targets in loading.resolved] == [[]]


def test_what_is_refused_of_a_target_already_is_not_said_again(shop, monkeypatch):  # law 26
    plan = shop.plan([action("arm", "move", arguments="0.1 9")], [action("bell")])
    target = TargetValues(0, 0, "joint object", (9.0,))

    def refused(*addresses):
        monkeypatch.setattr(
            plan_preparation, "resolve", lambda *_given: Resolution(plan, [target], refused={*addresses})
        )
        loading = Loading()
        return reasons(prepared(plan, target, loading=loading)), [targets for _, _, targets in loading.resolved]

    asked = [[("joint object", [9.0])]]
    assert refused() == (["host.values_unfit"], asked)
    assert refused((0, 0)) == ([], [[]])
    assert refused((1, 0)) == (["host.values_unfit"], asked)


def test_values_are_judged_also_where_a_constant_of_no_robot_is_read(shop):  # law 26
    shop.task("scale", "from onika.module import *\nclass Scale(Module):\n    K = OutConst('int', '-', 'a factor')\n")
    more = MOVE.replace("    end =", '    K = InConst("int", "-", "a factor")\n    end =')
    shop.task("more", more, aliases={"Q_REF": "P_REF"})
    plan = shop.plan([action("arm", "scale", "more", arguments="0.1 9")])
    assert reasons(prepared(plan)) == ["host.values_unfit"]


def test_a_bound_that_only_a_running_task_gives_is_left_to_the_run_and_reach_is_judged(shop):  # R-E03
    shop.task("limit", "from onika.module import *\nclass Limit(Module):\n    MOST = OutConst('double', 'm', 'most')\n")
    bound = MOVE.replace("    end =", '    MOST = InConst("double", "m", "most")\n    end =').replace(
        'high="QMAX"', 'high="MOST"'
    )
    shop.task("bounded", bound)
    plan = shop.plan([action("arm", "limit", "bounded", arguments="0.1 9")])
    target = TargetValues(0, 0, "joint object", (9.0,))
    assert prepared(plan, target).faults == []
    assert reasons(prepared(plan, target, loading=Loading(resolve=([UNLIKE],)))) == ["host.unreachable"]


def test_values_that_do_not_fit_are_told_with_their_task_and_target_or_job(shop):  # R-E03, R-X01
    plan = shop.plan([action("arm", "move", arguments="0.1")])
    for changed, name in ((plan, "there"), (with_actions(plan, target=None), "job0")):
        (fault,) = prepared(changed).faults
        assert (fault.reason.key, fault.reason.args["task"], fault.reason.args["target"]) == (
            "host.values_unfit",
            "move",
            name,
        )


def test_a_line_for_nobody_is_no_matter(shop):  # R-E03
    shop.task("bad", "class Bad(:\n")
    plan = shop.plan([action("arm", "bad", arguments="0.1")])
    assert [str(fault.place) for fault in prepared(plan).faults] == ["bad.py:1"]


def test_a_target_out_of_reach_is_told_once_and_one_without_a_name_too(shop):  # law 26
    plan = shop.plan([action("arm", "move", arguments="0.1 9"), action("arm", "move", arguments="0.1 0.2")])
    targets = [TargetValues(0, at, "joint object", (9.0,)) for at in range(2)]
    preparation = prepared(plan, *targets, loading=Loading(resolve=([UNLIKE, None],)))
    assert [fault.reason for fault in preparation.faults] == [Reason.of("host.unreachable", target="there", why=UNLIKE)]
    nameless = with_actions(plan, target=None, arguments="0.1 0.2")
    preparation = prepared(nameless, *targets, loading=Loading(resolve=([UNLIKE, None],)))
    assert [fault.reason for fault in preparation.faults] == [Reason.of("host.unreachable", target="", why=UNLIKE)]


def test_of_relative_targets_it_is_asked_in_the_order_in_which_the_robot_goes_there(shop):  # law 26, R-D25
    moves = action("arm", "move", arguments="0.1 0.2"), action("hand", "bell"), action("arm", "move", arguments="1 2")
    plan = shop.plan(list(moves))
    relative, first = TargetValues(0, 2, RELATIVE, (2.0,)), TargetValues(0, 0, "joint object", (0.0,))
    loading = Loading(resolve=([None, UNLIKE],))
    preparation = prepared(plan, relative, first, loading=loading)
    assert [targets for _, _, targets in loading.resolved] == [[("joint object", [0.0]), (RELATIVE, [2.0])]]
    unreachable = Reason.of("host.unreachable", target="there", why=UNLIKE)
    assert preparation.faults == [at_action(plan, 0, 2, unreachable)] != [at_action(plan, 0, 0, unreachable)]


def test_a_robot_that_cannot_judge_its_reach_is_a_fault(shop):  # R-B07
    broken = Fault(Place("arm.py", 7), UNLIKE, NOT_RUN)
    plan = shop.plan([action("arm", "move", arguments="0.1 0.2")])
    target = TargetValues(0, 0, "joint object", (0.1,))
    assert prepared(plan, target, loading=Loading(resolve=(broken,))).faults == [broken]
