"""Deadlocks of tags in words: who waits where for whom (R-X03)."""

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.plans.program_tree import Act, Loop, Pick, Side, planned
from onika.model.rules import meetings
from onika.words.fault import Place
from onika.words.reason import Reason

NOOP = Act(tasks=(), is_noop=True)


def plan_of(*trees):
    """The plan, its actions placed on lines of a file: action 0 of flow 0 on line 1, of flow 1 on line 101 …"""
    made = planned(*trees)
    flows = []
    for number, flow in enumerate(made.flows):
        fields = {name: getattr(flow, name) for name in flow.__struct_fields__}
        actions = tuple(placed(action, 100 * number + index + 1) for index, action in enumerate(flow.actions))
        flows.append(type(flow)(**fields | {"actions": actions}))
    return type(made)(made.application, tuple(flows), ())


def placed(action, line):
    fields = {name: getattr(action, name) for name in action.__struct_fields__}
    return type(action)(**fields | {"place": "x.appl", "line": line, "name": f"job{line}"})


def tags(text):
    return tuple(Act("" if part == "-" else part) for part in text.split())


def test_tags_in_the_wrong_order_name_the_circle_with_every_place_in_it():
    (fault,) = meetings.faults(plan_of(tags("- a b"), tags("b a")))
    assert fault.place == Place("x.appl", 2)
    assert str(fault.reason) == (
        "expected tags in an order in which the flows can meet"
        ", found flow0 waits at a (x.appl:2, job2) for flow1, which waits at b (x.appl:101, job101) for flow0"
    )
    assert str(fault.instead) == "the application is not run"


def test_a_flow_that_waits_for_an_ended_one_is_named():
    (fault,) = meetings.faults(plan_of(tags("a a"), tags("a")))
    assert str(fault.reason) == (
        "expected tags as often in each flow"
        ", found flow0 waits at a (x.appl:2, job2) for flow1, which has ended by then"
    )


def test_a_deadlock_that_depends_on_a_choice_is_a_note_with_the_choice():
    plan = plan_of((Act(), Pick((tags("a"), ()))), tags("a"))
    assert meetings.faults(plan) == ()
    (note,) = meetings.notes(plan)
    assert note.is_note
    assert str(note.reason) == (
        "expected tags as often in each flow, whatever is chosen"
        ", found flow1 waits at a (x.appl:101, job101) for flow0, which has ended by then"
        ", when flow0 takes flow 1 of a branch"
    )


def test_a_deadlock_in_a_nested_application_names_who_begins_whom():  # R-D13
    (fault,) = meetings.faults(plan_of((Side(((Act("n a"), Act("n a")), (Act("n a"),))),)))
    assert str(fault.reason) == (
        "expected tags in an order in which the flows can meet"
        ", found flow0 waits at a of n (x.appl:2, job2) for flow0.1, which is begun by flow0 only"
    )


def test_a_parent_that_waits_for_the_end_of_a_stuck_flow_is_not_told_as_another_deadlock():
    (fault,) = meetings.faults(plan_of((Side(((Act("n a"),), (Act("n a"), Act("n a")))), Act())))
    assert str(fault.reason) == (
        "expected tags in an order in which the flows can meet"
        ", found flow0 waits for the end of flow0.1, which waits at a of n (x.appl:102, job102) for flow0"
    )


def test_a_wait_for_a_flow_that_never_leaves_its_loop_is_a_note():
    (note,) = meetings.notes(plan_of(tags("a"), (Loop("l", (Act(), NOOP)), Act("a"))))
    assert str(note.reason).endswith("for flow1, which goes round in a loop that ends only when the user lets it leave")


def test_a_tag_that_one_flow_bears_alone_holds_nobody():  # model/rules/tag tells of it
    assert meetings.findings(plan_of(tags("- a"), tags("-"))) == ()


def test_what_cannot_be_looked_at_as_a_whole_is_said():
    several = (Act(), Pick((tags("a b c"), tags("a b c"), tags("a b c"))))
    (note,) = meetings.findings(plan_of(several, several, several), limit=5)
    assert note.is_note
    assert note.reason == Reason.of(
        "rules.tags_too_many",
        states=5,
        flows=(
            "flow0",
            "flow1",
            "flow2",
        ),
    )


def test_flows_that_can_always_meet_are_left_in_peace():
    loop = (Loop("l", (Act("a"), NOOP)),)
    assert meetings.findings(plan_of(loop, loop)) == ()
    assert meetings.findings(plan_of(tags("a b a"), tags("a b - a"), ())) == ()


@settings(max_examples=examples(100), deadline=None)
@given(st.lists(st.lists(st.sampled_from(["", "a", "b", "c"]).map(Act), max_size=5).map(tuple), min_size=2, max_size=4))
def test_every_finding_names_places_that_are_there(flows):
    plan = plan_of(*flows)
    lines = {action.line for flow in plan.flows for action in flow.actions}
    for fault in meetings.findings(plan):
        assert (fault.place.file, fault.place.line in lines) == ("x.appl", True)
        assert str(fault.reason).partition(", found ")[2].startswith("flow")
