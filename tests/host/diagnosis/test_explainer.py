"""Faults planted in flows that the real engine executes: the cause that is named is the planted one (X06)."""

import struct

import pytest
from msgspec import structs

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.rail_world import YardLoading
from onika.engine import news as said
from onika.engine.engine import Engine
from onika.host.diagnosis.explainer import Explainer
from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.host.loading.plan_preparation import prepare
from onika.ring.segment import Segment
from onika.runtime import news
from onika.runtime.table import Table
from onika.runtime.user_input import AskedItem
from onika.wire import steer
from onika.words.reason import Reason, as_reason
from onika.words.shape import Shape

MS = 1_000_000
ARM = """
from onika.module import InVar, Module, OutVar

class Arm(Module):
    hardware = True
    TAU = InVar("double", "N m", "wanted torque")
    Q = OutVar("double", "rad", "where it is")
"""
GO = """
from onika.module import Module, InVar, OutVar

class Go(Module):
    trigger = True
    Q = InVar("double", "rad", "where it is")
    TAU = OutVar("double", "N m", "wanted torque")
"""
SHOW = "from onika.module import Module\nclass Show(Module):\n    passive = True\n"
TASKS = ("arm", "go", "show")


class Run:
    """Flows of actions, each with a tag or none, under the real engine and an explainer; no task really lives."""

    def __init__(self, *flows, stands_still=True):
        shop = PlanBuilder()
        shop.task("arm", ARM, local={"DEVICE": "yard:m0"})
        shop.task("go", GO)
        shop.task("show", SHOW)
        plan = shop.plan(*([action(*TASKS) for _ in tags] for tags in flows))
        marked = (
            structs.replace(flow, actions=tuple(
                structs.replace(act, synch_tag=tag) for act, tag in zip(flow.actions, tags, strict=True)
            ))
            for flow, tags in zip(plan.flows, flows, strict=True)
        )  # fmt: skip
        self.plan = structs.replace(plan, flows=tuple(marked))
        self.prepared = prepare(self.plan, (), YardLoading())
        passive = {(number, "show") for number in range(len(flows))}
        ranks = {(number, name): rank for number in range(len(flows)) for rank, name in enumerate(TASKS)}
        triggers = self.prepared.triggers
        self.engine = Engine(self.plan, triggers, passive, ranks, stands_still=stands_still)
        self.tables = {flow.subsystem: Table(Segment.create("explained", 1 << 18)) for flow in self.plan.flows}
        self.told = []
        self.now = 1000 * MS
        self.explainer = Explainer(self.prepared, self.tables, self.engine.positions, self.told.append)
        self.explainer.begin(self.now)
        self.feed(said.Run())
        self.feed(*(said.Spawned(number, task) for number in range(len(flows)) for task in TASKS))
        self.feed(*(said.TurnedOn(number, task) for number in range(len(flows)) for task in TASKS))

    def feed(self, *reports):
        """As the runner does it: what has moved is looked at after each news."""
        for report in reports:
            self.engine.feed(report)
            self.explainer.moved()
            self.explainer.look(self.now)
        return self

    def finish(self, flow=0):
        return self.feed(said.Finished(flow, "go"), said.TurnedOn(flow, "go"))

    def write(self, name, value, subsystem="flow0"):
        table = self.tables[subsystem]
        table.entry(name, Shape.parse("double"))
        table.ring(name).write(struct.pack("=d", value))
        return self

    def fails(self, task, text="ValueError: no", flow=0, values=None):
        report = news.Failed(
            f"flow{flow}", task, "cycle", as_reason(text), f"{task}.py", 7, "", self.now, values=values or {}
        )
        with self.explainer.watch(report, self.now):
            self.feed(said.Failed(flow, task, as_reason(text)))
        return self

    def ends(self, why, item):
        with self.explainer.watch(why, self.now):
            self.feed(item)
        return self

    @property
    def explained(self):
        (explanation,) = self.told
        return explanation


def test_a_task_in_error_is_named_with_its_job_its_flow_and_who_waits():  # R-X06, R-E08
    run = Run([None, "meet"], [None, "meet"]).finish(1).fails("arm")
    explanation = run.explained
    assert (explanation.kind, explanation.subsystem, explanation.task, explanation.suspect) == (
        "error",
        "flow0",
        "arm",
        "",
    )
    assert (explanation.action, explanation.index, explanation.place) == ("action 0", 0, "test.appl:1")
    assert (str(explanation.text), explanation.path, explanation.line) == ("cycle: ValueError: no", "arm.py", 7)
    assert explanation.waiting == (("flow1", "meet"),)
    assert [command for command, _ in explanation.choices] == [
        "clear flow0", "next flow0", "skip flow0 N", "pass flow1", "abort",
    ]  # fmt: skip


def test_where_nobody_is_there_to_decide_the_run_ends_and_there_is_no_choice():  # R-E08, R-X06
    explanation = Run([None], stands_still=False).fails("arm").explained
    assert (explanation.task, explanation.action, explanation.choices) == ("arm", "action 0", ())


def test_a_passive_task_in_error_stops_nothing_and_is_not_explained():  # R-X06
    assert Run([None]).fails("show").told == []


def test_the_writer_upstream_of_what_is_no_number_is_suspected():  # R-X06, law 5
    run = Run([None]).write("TAU", float("nan")).write("Q", 1.0)
    explanation = run.fails("arm", "LawBroken: NaN or infinity in TAU", values={"TAU": float("nan")}).explained
    assert (explanation.task, explanation.suspect) == ("arm", "go")
    assert str(explanation.text).endswith("; TAU is no number: made by go, of proper numbers")


def first_written(reason, task, variable):
    return Reason.of("runtime.first_written", reason=reason, task=task, variable=variable)


def test_whom_the_processing_unit_saw_write_it_first_is_suspected():  # R-X06, law 5
    run = Run([None]).write("TAU", float("nan")).write("Q", float("nan"))
    explanation = run.fails("arm", first_written("NaN or infinity in TAU", "show", "Q")).explained
    assert (explanation.suspect, str(explanation.text)) == (
        "show",
        "cycle: NaN or infinity in TAU; first written by task show, in Q",
    )
    run = Run([None]).write("TAU", float("nan")).write("Q", 1.0)
    explanation = run.fails("arm", first_written("NaN in TAU", "go", "TAU")).explained
    assert (explanation.suspect, explanation.text.key) == ("go", "host.entry_failed")
    assert Run([None]).fails("arm", first_written("NaN", "nobody", "Q")).explained.suspect == ""


def test_what_a_task_read_counts_even_if_the_table_says_something_else_by_now():  # R-X06
    run = Run([None]).write("TAU", 1.0).write("Q", 1.0)
    assert run.fails("arm", values={"TAU": float("inf")}).explained.suspect == "go"
    run = Run([None]).write("TAU", float("inf")).write("Q", 1.0)
    assert run.fails("arm", values={"TAU": 2.0}).explained.suspect == ""


def test_the_last_seconds_of_its_variables_are_told_with_their_units():  # R-X06
    run = Run([None])
    for value in (1.0, 2.0, 3.0):
        run.write("TAU", value).write("Q", -value).explainer.tick(run.now)
        run.now += 50 * MS
    run.write("TAU", 4.0)
    tau, q = run.fails("arm").explained.courses
    assert (tau.variable, tau.unit, tau.values, tau.at_s) == ("TAU", "N m", (1.0, 2.0, 3.0, 4.0), (0, 0.05, 0.1, 0.15))
    assert (q.variable, q.unit, q.values[-1]) == ("Q", "rad", -3.0)


@pytest.mark.parametrize(
    ("key", "kind", "first"),
    [
        ("runtime.button_pressed", "pressed", "host.once_let_go"),
        ("runtime.drive_tripped", "tripped", "host.once_free"),
    ],
)
def test_a_drive_that_holds_is_told_with_what_must_be_done_first(key, kind, first):  # R-X06, R-K06
    raised = Reason.of("runtime.raised", kind="ModuleError", why=Reason.of(key))
    explanation = Run([None]).fails("arm", raised).explained
    assert (explanation.kind, explanation.task) == (kind, "arm")
    assert dict(explanation.choices)["clear"].key == first


@pytest.mark.parametrize("kind", ["ILLEGAL", "SHUTDOWN"])
def test_a_task_that_may_not_go_on_ends_the_run(kind):  # R-A08, R-X06
    report = news.Signalled("flow0", "arm", kind, 0, Reason.plain("too hot"), 0)
    explanation = Run([None]).ends(report, said.Illegal(0, "arm", Reason.plain("too hot"))).explained
    assert (explanation.kind, explanation.task, str(explanation.text), explanation.choices) == (
        kind.lower(),
        "arm",
        f"{kind}: too hot",
        (),
    )


def test_a_question_that_nobody_answers_ends_the_run():  # R-X06, law 25
    items = (AskedItem("goal", "double", 1, "rad", "", None, None, None),)
    report = news.Asked("flow0", "go", Reason.plain("7 is beyond 2.6"), items, 0)
    explanation = Run([None]).ends(report, said.Abort(Reason.plain("nobody"))).explained
    assert (explanation.kind, explanation.task) == ("asking", "go")
    assert "asks for goal (7 is beyond 2.6)" in str(explanation.text)


def test_a_lost_process_names_the_task_in_whose_call_it_was():  # R-A16, R-X06
    during = Reason.of("host.in_call", task="flow0/go")
    reason = Reason.of("host.process_ended", name="rt0", code=3, during=during)
    explanation = Run([None]).ends(Cause(CauseKind.LOST, reason), said.Abort(reason)).explained
    assert (explanation.kind, explanation.subsystem, explanation.task, explanation.action) == (
        "lost",
        "flow0",
        "go",
        "action 0",
    )


def test_what_the_user_wanted_blames_nobody():  # R-X06
    explanation = (
        Run([None])
        .ends(Cause(CauseKind.USER, Reason.plain("stopped (Ctrl-C)")), said.Abort(Reason.plain("stopped")))
        .explained
    )
    assert (explanation.kind, explanation.subsystem, explanation.task, str(explanation.text)) == (
        "user",
        "",
        "",
        "stopped (Ctrl-C)",
    )


def test_an_end_is_explained_once():  # R-X06
    run = Run([None], stands_still=False).fails("arm").fails("go")
    run.ends(Cause(CauseKind.USER, Reason.plain("enough")), said.Abort(Reason.plain("enough")))
    assert run.explained.task == "arm"
    assert run.explainer.wake_at() is None


def test_of_two_causes_one_within_the_other_the_inner_one_counts():  # R-X06
    run = Run([None], stands_still=False)
    with run.explainer.watch(Cause(CauseKind.USER, Reason.plain("outer")), run.now):
        run.fails("arm")
    assert run.explained.task == "arm"


def test_flows_that_wait_in_a_circle_are_told_once():  # R-X03, R-X06
    run = Run([None, "a", "b"], [None, "b", "a"]).finish(0)
    assert run.told == []
    run.finish(1)
    assert (run.explained.kind, run.explained.subsystem) == ("deadlock", "flow0")
    assert str(run.explained.text).startswith("flow0 waits at a for flow1, flow1 waits at b for flow0")
    assert [command for command, _ in run.explained.choices] == ["pass flow0", "pass flow1", "abort"]
    run.feed(said.TurnedOn(0, "show"))
    assert len(run.told) == 1


def test_a_flow_that_waits_for_one_that_has_ended_is_told():  # R-X03, R-X06
    run = Run(["a", None], ["a", "a"])  # the first visit of both is one meeting; flow0 makes no second one
    run.finish(0).finish(0)
    run.finish(1)
    explanation = run.explained
    assert (explanation.kind, explanation.subsystem) == ("deserted", "flow1")
    assert str(explanation.text) == "flow1 waits at a for flow0, which has ended"
    assert [command for command, _ in explanation.choices] == ["pass flow1", "abort"]


def test_whoever_comes_to_wait_for_a_flow_that_stands_is_told_then():  # R-X06
    run = Run([None, "a"], [None, "a"]).fails("arm")
    run.finish(1)
    stop, waits = run.told
    assert (stop.kind, stop.waiting) == ("error", ())
    assert (waits.kind, waits.subsystem) == ("deserted", "flow1")
    assert str(waits.text) == "flow1 waits at a for flow0, which stands still at an error"
    assert [command for command, _ in waits.choices] == [
        "clear flow0", "next flow0", "skip flow0 N", "pass flow1", "abort",
    ]  # fmt: skip


def test_whoever_waited_before_is_told_with_the_stop_only():  # R-X06
    run = Run([None, "a"], [None, "a"]).finish(1).fails("arm")
    assert run.explained.kind == "error"


def test_a_flow_that_would_not_be_cleared_is_explained_anew():  # R-E08, R-X06
    run = Run([None]).fails("arm")
    run.feed(steer.Recover("flow0"))
    why = Reason.of("runtime.button_still_pressed")
    run.ends(news.Refused("flow0", "arm", "clear", why), said.Refused(0, "arm", why))
    _, again = run.told
    assert (again.kind, again.task) == ("refused", "arm")
    assert (again.text.key, again.text.args["why"]) == ("host.command_refused", why)
    assert str(dict(again.choices)["clear"]).startswith("once the panic button is let go: clears arm and repeats")
