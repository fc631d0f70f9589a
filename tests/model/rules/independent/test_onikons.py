"""Equation (7), holes and loops: ours and the naive reading agree on any flow in any syntax."""

from dataclasses import replace

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.application import AppFlow, Hole, Icon
from onika.model.rules import jigsaw, loop
from onika.model.syntax import IconType, Syntax
from onika.words.fault import Place
from onika.words.reason import Reason

from . import onikons as naive
from .drawn import PLACEABLE, TYPES, edges_of, flow, icon, line, lines, marked, syntaxes

places = st.integers(-1, 5)

FLOW = Reason.of("rules.flow", number=0)


def insertions_agree(syntax: Syntax, kinds: naive.Line, after: int, kind: str) -> None:
    edges = edges_of(syntax)
    kinds = naive.settled(kinds, edges)
    after = min(after, len(kinds) - 1)
    reasons = jigsaw.refusals(flow(kinds), after, icon(kind), syntax)
    assert (not reasons) == naive.may_insert(kinds, after, kind, edges)
    if not reasons:
        insert = jigsaw.insert(flow(kinds), after, icon(kind), syntax)
        assert line(insert) == naive.insert(kinds, after, kind, edges)


def deletions_agree(syntax: Syntax, kinds: naive.Line, at: int) -> None:
    kinds = naive.settled(kinds, edges_of(syntax))
    at = min(max(at, 0), len(kinds) - 1)
    if kinds and kinds[at] is not None:
        assert line(jigsaw.delete(flow(kinds), at, syntax)) == naive.delete(kinds, at, edges_of(syntax))


def loops_agree(kinds: naive.Line, syntax: Syntax, data: st.DataObject) -> None:
    """Of a stray target, whose mark is nobody's, readiness speaks."""
    edges = edges_of(syntax)
    groups = naive.actions(kinds, edges)
    drawn = data.draw(marked(kinds))
    owned = {at for group in groups for at in group}
    steps = tuple(
        replace(step, while_tag=None) if isinstance(step, Icon) and at not in owned else step
        for at, step in enumerate(drawn.steps)
    )
    tags = {at: step.while_tag for at, step in enumerate(steps) if isinstance(step, Icon) and step.while_tag}
    tests = {at: step.while_test for at, step in enumerate(steps) if isinstance(step, Icon)}
    faults = loop.faults(replace(drawn, steps=steps), syntax, FLOW, Place("x"))
    assert (not faults) == naive.loops_are_well_formed(groups, tags, tests)


@given(syntaxes(), lines, places, st.sampled_from((*PLACEABLE, "Odd object")))
@settings(max_examples=examples(250), deadline=None)
def test_any_icon_is_inserted_or_refused_alike(syntax: Syntax, kinds: naive.Line, after: int, kind: str) -> None:
    insertions_agree(syntax, kinds, after, kind)  # R-D03, R-D19, R-D22


@given(syntaxes(), lines, places)
@settings(max_examples=examples(250), deadline=None)
def test_any_deletion_opens_and_closes_the_same_holes(syntax: Syntax, kinds: naive.Line, at: int) -> None:
    deletions_agree(syntax, kinds, at)  # R-D19


@given(syntaxes(), lines)
@settings(max_examples=examples(250), deadline=None)
def test_a_flow_is_whole_for_both_or_for_neither(syntax: Syntax, kinds: naive.Line) -> None:
    is_whole = None not in kinds and not jigsaw.misfits(flow(kinds), syntax)  # R-D03, R-E01
    assert is_whole == naive.is_whole(kinds, edges_of(syntax))


@given(lines, syntaxes(), st.data())
@settings(max_examples=examples(250), deadline=None)
def test_any_loops_are_judged_alike(kinds: naive.Line, syntax: Syntax, data: st.DataObject) -> None:
    loops_agree(kinds, syntax, data)  # R-E01, readings 23, 24


@given(st.lists(st.sampled_from(["Complete job", "Complete NOP"]), min_size=2, max_size=6), st.data())
@settings(max_examples=examples(250), deadline=None)
def test_loops_over_whole_actions_are_judged_alike(kinds: naive.Line, data: st.DataObject) -> None:
    loops_agree(kinds, data.draw(syntaxes()), data)  # R-E01, reading 23


@given(syntaxes())
@settings(max_examples=20, deadline=None)
def test_start_and_end_are_placed_by_nobody(syntax: Syntax) -> None:
    for kind in TYPES[:2]:  # R-D04
        assert jigsaw.refusals(flow([]), -1, icon(kind), syntax)


PAIRS: list[naive.Line] = [["Joint job", "Joint object"], ["Complete job"], ["Odd job"]]


@given(st.lists(st.sampled_from(PAIRS), min_size=1, max_size=4), st.data())
@settings(max_examples=examples(250), deadline=None)
def test_loops_over_jobs_and_their_targets_are_judged_alike(groups: list[naive.Line], data: st.DataObject) -> None:
    loops_agree([kind for group in groups for kind in group], data.draw(syntaxes()), data)  # R-D06, reading 24


def test_a_hole_that_stays_keeps_the_unknown_target_in_it() -> None:
    types = (("Application start", 0, 0), ("Application end", 0, 0), ("Complete job", 0, 0), ("Joint job", 0, 1))
    syntax = Syntax(tuple(IconType(*each) for each in types), ())  # R-D16, R-D19, R-B07
    unknown = Hole(kept="what the file says of it")
    before = AppFlow((icon("Joint job"), unknown))
    assert jigsaw.insert(before, -1, icon("Joint job"), syntax).steps[-1] == unknown
    assert jigsaw.delete(AppFlow((icon("Joint job"), icon("Complete job"), unknown)), 1, syntax) == before
    assert jigsaw.delete(AppFlow((icon("Joint job"), unknown, icon("Complete job"))), 2, syntax) == before


def test_an_action_is_in_one_loop_whichever_of_its_icons_bears_the_mark() -> None:
    types = (("Complete job", 0, 0), ("Joint job", 0, 1), ("Joint object", 1, 0))
    syntax = Syntax(tuple(IconType(*each) for each in types), ())  # R-D06, readings 23, 24
    kinds: naive.Line = ["Joint job", "Joint object", "Complete job", "Complete job"]

    def sentences(tags: list[str | None], tests: list[bool]) -> list[str]:
        marks = zip(kinds, tags, tests, strict=True)
        steps = tuple(replace(icon(kind or ""), while_tag=tag, while_test=test) for kind, tag, test in marks)
        return [str(fault.reason) for fault in loop.faults(AppFlow(steps), syntax, FLOW, Place("x"))]

    assert sentences(["a", "a", "a", None], [True, True, False, False]) == []
    assert sentences(["a", "a", "a", None], [False, True, False, False]) == []
    assert sentences(["a", "b", "b", "a"], [True, True, False, False]) == [
        "expected one loop tag at an action of flow 0, found a and b at `it`, step 0"
    ]


@pytest.mark.slow
@given(syntaxes(), lines, places, st.sampled_from(PLACEABLE), st.data())
@settings(max_examples=examples(2500), deadline=None)
def test_thousands_of_flows_are_judged_alike(
    syntax: Syntax, kinds: naive.Line, at: int, kind: str, data: st.DataObject
) -> None:
    insertions_agree(syntax, kinds, at, kind)  # R-D03, R-D19
    deletions_agree(syntax, kinds, at)
    loops_agree(kinds, syntax, data)
