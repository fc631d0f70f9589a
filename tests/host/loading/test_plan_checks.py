import pytest
from msgspec import structs

from kit.plans.plan_builder import PlanBuilder, action
from kit.runtime.live_edits import SOURCE
from kit.worlds.rail_world import YardLoading
from onika.host.loading.plan_checks import (
    absent_devices,
    at_action,
    conflicts,
    cycles,
    note_at,
    remarks,
    shapeless,
    shared_devices,
    unfit,
    unfit_together,
    wrong_rates,
)
from onika.module import InConst, InVar, Module, OutConst, OutVar
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.wiring import wire
from onika.wire.plan import Code
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import NOTHING, Reason


def wired(name, module="", hardware=False, device=None, **ports):
    planned = PlanBuilder().task(name, SOURCE, module=module, local={"DEVICE": device} if device else None)
    return wire(planned, sheet_of(type(name, (Module,), {"hardware": hardware, **ports})))


def sentences(faults):
    return [str(fault.reason) for fault in faults]


def test_one_module_lives_once():  # law 9
    assert sentences(conflicts([wired("a", "ramp"), wired("b", "ramp"), wired("c")])) == [
        "expected module ramp once in a flow, found also in task a"
    ]


def test_one_constant_has_one_supplier():  # law 9
    tasks = [wired("a", N=OutConst("int")), wired("b", N=OutConst("int"))]
    assert sentences(conflicts(tasks)) == ["expected one supplier of the constant N, found also task a"]


def test_what_is_written_at_every_cycle_is_no_constant():  # law 9
    tasks = [wired("a", N=OutVar("int")), wired("b", N=InConst("int"))]
    assert sentences(conflicts(tasks)) == ["expected a constant N, found task a writes it at every cycle"]
    assert conflicts([wired("a", N=OutVar("int")), wired("b", N=InVar("int"))]) == []


def test_constants_that_wait_for_each_other_are_named_as_a_ring():  # law 10
    tasks = [wired("a", N=OutConst("int"), M=InConst("int")), wired("b", M=OutConst("int"), N=InConst("int"))]
    assert sentences(cycles(tasks)) == ["expected constants that do not wait for each other, found a → b"]
    assert cycles(tasks[:1]) == []


def test_a_device_is_claimed_by_one_hardware_task():  # law 16
    first, two = (wired(name, hardware=True, device="yard:m0") for name in "ab")
    listener = wired("c", device="yard:m0")
    assert sentences(shared_devices([first, two, listener])) == [
        "expected device yard:m0 for one task, found task a claims it too"
    ]
    assert shared_devices([first, listener]) == []


@pytest.mark.parametrize(("device", "count"), [("yard:m0", 0), ("yard:m7", 1), ("no:m0", 1), (None, 0)])
def test_a_device_is_one_of_a_world(device, count):  # law 16
    assert len(absent_devices([wired("a", device=device)], YardLoading())) == count


def test_who_shapes_itself_states_the_dimension_before_it_lives():  # law 7
    source = wired("a", N=OutConst("int"), ROW=OutVar("double[N]"))
    assert len(shapeless([source], {})) == 1
    assert shapeless([source], {"N": 3}) == []
    assert shapeless([wired("b", N=InConst("int"), ROW=OutVar("double[N]"))], {}) == []


@pytest.mark.parametrize(("hz", "is_wrong"), [(1e-3, False), (1e6, False), (9e-4, True), (1.1e6, True), (-5.0, True)])
def test_a_rate_has_a_period(hz, is_wrong):  # R-A04
    assert bool(wrong_rates([(Place("x.conf", 3), " in JOB", "a", hz)], (), Reason.plain("no"))) is is_wrong


def test_hardware_is_not_slower_than_its_drive_allows():  # law 17
    given = [(Place("x.conf", 3), " in JOB", "a", 39.0), (Place("x.conf", 4), " in JOB", "b", 39.0)]
    (fault,) = wrong_rates(given, {"a"}, Reason.plain("no"))
    assert (fault.place.line, fault.reason) == (
        3,
        Reason.of("host.hardware_too_slow_in", task="a", job=" in JOB", slowest=40.0, hz=39.0),
    )


class NamedWorlds(YardLoading):
    """Knows no world, for one reason or another."""

    def devices(self, world):
        key = "host.no_such_world" if world == "none" else "host.no_plan"
        args = {"worlds": ("yard",), "name": world} if world == "none" else {}
        return Fault(Place("w"), Reason(key, "why", args), NOT_RUN) if world != "yard" else ("m0",)


def fault_of(task, reason):
    return Fault(Place(task.task.place), reason, NOT_RUN)


def test_every_fault_stands_where_its_task_does_and_says_all_of_it():  # R-E01
    a, b = wired("a", "ramp", N=OutConst("int")), wired("b", "ramp", N=OutConst("int"))
    assert conflicts([a, b]) == [
        fault_of(b, Reason.of("host.module_twice", module="ramp", other="a")),
        fault_of(b, Reason.of("host.constant_twice", constant="N", other="a")),
    ]
    first, two = (wired(name, hardware=True, device="yard:m0") for name in "ab")
    nobody = [wired(name, hardware=True) for name in "cd"]
    claimed = Reason.of("host.device_claimed", device="yard:m0", other="a")
    listener = wired("listener", device="yard:m0")
    assert shared_devices([listener, *nobody, first, two]) == [fault_of(two, claimed)]
    others = [wired("e", hardware=True, device="yard:m0"), wired("f", hardware=True, device="yard:m1")]
    assert shared_devices(others) == []


def test_two_constants_of_two_suppliers_are_no_conflict():  # law 9
    assert conflicts([wired("a", N=OutConst("int")), wired("b", M=OutConst("int"))]) == []


def test_a_ring_of_constants_stands_at_the_first_task():  # law 10
    tasks = [wired("a", N=OutConst("int"), M=InConst("int")), wired("b", M=OutConst("int"), N=InConst("int")),
             wired("c")]  # fmt: skip
    assert cycles(tasks) == [fault_of(tasks[0], Reason.of("host.constants_wait", cycle="a → b"))]


def test_a_device_that_is_not_there_is_told_with_those_that_are():  # law 16
    tasks = [wired("a", device="yard:m7"), wired("b", device="none:m0"), wired("c", device="broken:m0"), wired("d")]
    assert absent_devices(tasks, NamedWorlds()) == [
        fault_of(tasks[0], Reason.of("host.no_such_device", world="yard", devices=("m0",), device="yard:m7")),
        fault_of(tasks[1], Reason.of("host.no_world_of_device", worlds=("yard",), device="none:m0")),
        fault_of(tasks[2], Reason("host.no_plan", "why", {})),
    ]


def test_a_dimension_that_is_not_stated_is_told_with_the_variable_that_needs_it():  # law 7
    source = wired("a", "ramp", N=OutConst("int"), ROW=OutVar("double[N]"))
    reason = Reason.of("host.constant_not_given", name="N", module="ramp", svar="ROW", shape="double[N]")
    assert shapeless([source], {}) == [fault_of(source, reason)]


INSTEAD = Reason.plain("no")
SLOW, FAST = {"slowest": 1e-3, "fastest": 1e6}, {"slowest": 40.0}


@pytest.mark.parametrize(
    ("job", "hz", "reason"),
    [
        (None, 2e6, Reason.of("host.rate_outside_now", task="a", hz=2e6, **SLOW)),
        ("JOB", 2e6, Reason.of("host.rate_outside_in", task="a", job="JOB", hz=2e6, **SLOW)),
        ("", 2e6, Reason.of("host.rate_outside", task="a", hz=2e6, **SLOW)),
        (None, 39.0, Reason.of("host.hardware_too_slow_now", task="a", hz=39.0, **FAST)),
        ("JOB", 39.0, Reason.of("host.hardware_too_slow_in", task="a", job="JOB", hz=39.0, **FAST)),
        ("", 39.0, None),
        (None, 40.0, None),
        (None, 50.0, None),
        (None, 1_000_000.5, Reason.of("host.rate_outside_now", task="a", hz=1_000_000.5, **SLOW)),
    ],
)
def test_a_rate_is_told_with_where_it_is_given_and_what_it_may_be(job, hz, reason):  # law 17
    place = Place("x.conf", 3)
    expected = [Fault(place, reason, INSTEAD)] if reason is not None else []
    assert wrong_rates([(place, job, "a", hz)], {"a"}, INSTEAD) == expected


def test_a_fault_of_an_action_stands_at_its_icon_and_says_which_it_is():  # R-E01, R-X01
    why = Reason.plain("why")
    plan = PlanBuilder()
    plan.task("a", SOURCE)
    flows = plan.plan([action("a")], [action("a"), action("a")])
    fault = at_action(flows, 1, 1, why)
    assert fault == Fault(Place("test.appl", 102), why, NOT_RUN)
    assert fault.where == Reason.of("host.where", flow="flow1", action=2, name="action 1")
    nested = structs.replace(flows.flows[0].actions[0], within=("all", "half"))
    inner = structs.replace(flows, flows=(structs.replace(flows.flows[0], actions=(nested,)),))
    where = Reason.of("host.where_within", flow="flow0", action=1, application="all / half", name="action 0")
    assert at_action(inner, 0, 0, why).where == where


CODE = Code("digest", "arm", "arm.py", "")
UNLIKE, ASIDE = Reason.plain("it has five joints"), Reason.plain("it stands elsewhere")


class Judged(YardLoading):
    """Says of devices what it is told to say, and remembers what it was asked."""

    def __init__(self, fits=NOTHING, company=()):
        super().__init__()
        self._fits, self._company = fits, company
        self.questions = []

    def fits(self, code, constants, device):
        self.questions.append((code, constants, device))
        return self._fits

    def company(self, world, names, *, is_of_flow=False):
        self.questions.append((world, names, is_of_flow))
        return self._company


def test_a_device_that_is_another_one_than_a_task_means_is_told():  # law 16, R-K05
    task = wired("a", hardware=True, device="yard:m0")
    loading = Judged(UNLIKE)
    reason = Reason.of("host.device_unlike", task="a", device="yard:m0", why=UNLIKE)
    assert unfit(task, CODE, {"N": 6}, loading) == [fault_of(task, reason)]
    assert loading.questions == [(CODE, {"N": 6}, "yard:m0")]
    assert unfit(task, CODE, {}, Judged()) == []


def test_what_a_device_is_like_is_asked_of_tasks_with_one_only_and_a_module_that_cannot_say_is_a_fault():  # R-B07
    broken = Fault(Place("arm.py", 3), UNLIKE, NOT_RUN)
    loading = Judged(broken)
    assert unfit(wired("a", hardware=True), CODE, {}, loading) == []
    assert loading.questions == []
    assert unfit(wired("a", device="yard:m0"), CODE, {}, loading) == [broken]


def devices(*names):
    return [wired(name, hardware=True, device=device) for name, device in zip("bacd", names, strict=False)]


def test_devices_that_do_not_go_together_are_told_at_the_last_of_their_tasks():  # law 18
    tasks = devices("yard:m1", "yard:m0", "field:m0")
    loading = Judged(company=(UNLIKE, ASIDE))
    whys = [Reason.of("host.devices_unfit", world="yard", why=why) for why in (UNLIKE, ASIDE)]
    assert unfit_together([wired("z", hardware=True), wired("y", device="yard:m7"), *tasks], loading) == [
        fault_of(tasks[0], why) for why in whys
    ]
    assert loading.questions == [("yard", ("m0", "m1"), False)]


def test_devices_that_are_named_in_the_reason_are_told_at_their_own_task():  # law 18, R-B07
    why = Reason.of("workcell.one_place", first="m1", other="m0")
    tasks = [*devices("yard:m1", "yard:m0"), wired("hand", hardware=True, device="yard:m2")]
    told = unfit_together(tasks, Judged(company=(why,)))
    assert told == [fault_of(tasks[0], Reason.of("host.devices_unfit", world="yard", why=why))]


def test_one_device_alone_goes_with_everything_and_a_world_that_cannot_say_is_one_fault():  # law 18, R-B07
    broken = Fault(Place("w"), UNLIKE, NOT_RUN)
    assert unfit_together(devices("yard:m0", "field:m0"), Judged(company=(UNLIKE,))) == []
    assert unfit_together(devices("yard:m0", "field:m0", "yard:m1", "field:m1"), Judged(company=broken)) == [broken]


def test_a_note_says_where_it_stands_by_line_where_there_is_one():  # R-X01
    note = Reason.plain("odd")
    assert note_at(Place("a.appl", 3), note) == Reason.of("host.note_at", file="a.appl", line=3, note=note)
    assert note_at(Place("a.rmod"), note) == Reason.of("host.note_in", file="a.rmod", note=note)


def test_what_is_odd_about_the_devices_of_a_flow_is_noted_at_the_task_that_it_names():  # R-K02
    tasks = devices("yard:m1", "yard:m0", "field:m0")
    named = Reason.of("host.device_claimed", device="m0", other="m7")
    loading = Judged(company=(named, ASIDE))
    assert remarks([wired("z", hardware=True), wired("y", device="yard:m7"), *tasks], loading) == [
        note_at(Place("a.rmod"), named),
        note_at(Place("yard"), ASIDE),
    ]
    assert loading.questions == [("yard", ("m0", "m1"), True)]


def test_nothing_is_odd_about_one_device_or_a_world_that_cannot_say():  # R-B07
    broken = Fault(Place("w"), UNLIKE, NOT_RUN)
    assert remarks(devices("yard:m0", "field:m0"), Judged(company=(UNLIKE,))) == []
    assert remarks(devices("yard:m0", "yard:m1"), Judged(company=broken)) == []
