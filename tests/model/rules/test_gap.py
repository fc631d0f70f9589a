from itertools import pairwise

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.application import AppFlow, Branch, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.gap import Row, either, kind_at, kinds
from onika.model.rules.jigsaw import exchange, fits, insert_all, refusals, take_out
from onika.model.syntax import IconType, Syntax

KINDS = {
    "Application start": (0, 0),
    "Application end": (0, 0),
    "Complete job": (0, 0),
    "Complete NOP": (0, 0),
    "Joint job": (0, 1),
    "Other job": (0, 2),
    "Joint object": (1, 0),
    "Other object": (2, 0),
    "Bridge object": (1, 2),
}
SYNTAX = Syntax(tuple(IconType(name, *edges) for name, edges in KINDS.items()), ())


def icon(kind, more=(), number=0):
    return Icon(Onikon(kind.split()[0].lower(), kind, "", (), blank(), more), number=number)


GRIP, JOB, TARGET = icon("Complete job"), icon("Joint job"), icon("Joint object")
BOTH = icon("Joint job", ("Other object",))
TWICE = icon("Joint job", ("Joint object",))
SOLIDS = [GRIP, JOB, TARGET, BOTH, TWICE, icon("Other job"), icon("Other object"), icon("Bridge object"), Branch(())]


def holes_stand_where_neighbours_do_not_fit(flow):
    """Equation (7) for every pair of neighbours, as they stand there."""
    every = kinds(flow, SYNTAX)
    steps = [None, *flow.steps, None]
    for at, (left, right) in enumerate(pairwise(every)):
        if not isinstance(steps[at], Hole) and not isinstance(steps[at + 1], Hole):
            assert left is None or right is None or fits(left, right), flow
    for at, step in enumerate(flow.steps):
        if isinstance(step, Hole):
            assert not isinstance(steps[at], Hole), "never two beside each other"
            bare = AppFlow((*flow.steps[:at], *flow.steps[at + 1 :]))
            left, right = kinds(bare, SYNTAX)[at : at + 2]
            assert left is not None and right is not None and not fits(left, right), (flow, at)


kind = st.sampled_from(["insert", "several", "take", "exchange"])
draws = st.lists(st.integers(0, 8), min_size=1, max_size=4)
deeds = st.lists(st.tuples(kind, st.integers(0, 99), draws), max_size=14)


def single(item):
    """Icons whose edges do not depend on what stands beside."""
    return not (isinstance(item, Icon) and item.onikon.more_targets)


def carried_out(flow, deed, solids):
    kind, place, draws = deed
    steps = [solids[draw % len(solids)] for draw in draws]
    at = place % (len(flow.steps) + 1) - 1
    if kind == "take":
        return take_out(flow, {(at + draw) % len(flow.steps) for draw in draws}, SYNTAX) if flow.steps else flow
    if kind == "exchange":
        return flow if at < 0 or isinstance(flow.steps[at], Hole) else exchange(flow, at, steps[0], SYNTAX)
    steps = steps if kind == "several" else steps[:1]
    return flow if refusals(flow, at, steps[0], SYNTAX) else insert_all(flow, at, steps, SYNTAX)


@given(deeds)
@settings(max_examples=examples(300), deadline=None)
def test_a_hole_stands_exactly_where_neighbours_do_not_fit_whatever_was_done(acts):  # R-D03, R-D19, Equation (7)
    flow = AppFlow(())
    for deed in acts:
        flow = carried_out(flow, deed, [item for item in SOLIDS if single(item)])
        holes_stand_where_neighbours_do_not_fit(flow)


@given(deeds)
@settings(max_examples=examples(300), deadline=None)
def test_with_several_targets_no_two_neighbours_misfit_either(acts):  # R-D13, R-D19
    flow = AppFlow(())
    for deed in acts:
        flow = carried_out(flow, deed, SOLIDS)
        every = kinds(flow, SYNTAX)
        steps = [None, *flow.steps, None]
        for at, (left, right) in enumerate(pairwise(every)):
            if not isinstance(steps[at], Hole) and not isinstance(steps[at + 1], Hole):
                assert fits(left, right), flow
        assert not any(isinstance(part, Hole) and isinstance(other, Hole) for part, other in pairwise(flow.steps))


def test_nothing_but_the_holes_is_ever_added_or_lost():
    flow = insert_all(AppFlow((GRIP,)), -1, (JOB, TARGET, icon("Other job")), SYNTAX)
    assert flow.steps == (JOB, TARGET, icon("Other job"), Hole(), GRIP)
    assert take_out(flow, {0, 2}, SYNTAX).steps == (Hole(), TARGET, GRIP)


def test_a_hole_that_keeps_lines_stays_until_it_is_filled_or_taken_out():  # R-D16
    kept = Hole(kept="ROUTINE mars\n", number=7)
    flow = AppFlow((GRIP, kept, GRIP))
    assert take_out(flow, {0}, SYNTAX).steps == (kept, GRIP)
    assert take_out(flow, {2}, SYNTAX).steps == (GRIP, kept)
    assert take_out(flow, {1}, SYNTAX).steps == (GRIP, GRIP)
    assert insert_all(flow, 0, (GRIP,), SYNTAX).steps == (GRIP, GRIP, GRIP)
    wanted = AppFlow((JOB, kept, GRIP))
    assert take_out(wanted, {1}, SYNTAX).steps == (JOB, Hole(), GRIP)
    assert insert_all(wanted, 0, (TARGET,), SYNTAX).steps == (JOB, TARGET, GRIP)


def test_a_hole_keeps_its_number_as_long_as_it_is_there():  # R-D05
    flow = insert_all(AppFlow((JOB, Hole(number=5), GRIP)), 0, (icon("Bridge object"),), SYNTAX)
    assert [step.number for step in flow.steps if isinstance(step, Hole)] == [5]


def test_of_two_holes_that_come_together_what_is_kept_counts():
    plain, kept = Hole(number=1), Hole(kept="x", number=2)
    assert either(plain, kept) is kept
    assert either(kept, plain) is kept
    assert either(kept, kept).kept == "xx"
    assert either(None, plain) is plain
    assert either(plain, None) is plain


def test_the_edge_of_a_target_is_the_one_it_has_where_it_stands():  # R-D13
    flow = AppFlow((BOTH, TARGET, GRIP))
    assert kind_at(flow, 1, SYNTAX).right_edge == 2
    assert kind_at(flow, 0, SYNTAX).right_edge == 1
    assert kind_at(flow, -1, SYNTAX).name == "Application start"
    assert kind_at(AppFlow((TARGET,)), 0, SYNTAX).right_edge == 0


def test_a_flow_taken_apart_and_put_together_is_the_same():
    flow = AppFlow((JOB, Hole(), GRIP, BOTH, TARGET, Hole()))
    assert Row.of(flow).mended((), SYNTAX) == flow
