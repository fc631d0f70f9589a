from itertools import pairwise

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.application import AppFlow, Branch, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.jigsaw import delete, fits, insert, misfits, refusals
from onika.model.syntax import IconType, Syntax
from onika.words.reason import Reason

KINDS = {
    "Application start": (0, 0),
    "Application end": (0, 0),
    "Complete job": (0, 0),
    "Complete NOP": (0, 0),
    "Joint job": (0, 1),
    "Joint object": (1, 0),
    "Bridge object": (1, 2),
    "Other object": (2, 0),
}
SYNTAX = Syntax(tuple(IconType(name, *edges) for name, edges in KINDS.items()), ())
PLACEABLE = [name for name in KINDS if name not in ("Application start", "Application end")]


def icon(kind: str) -> Icon:
    return Icon(Onikon(kind.split(maxsplit=1)[0].lower(), kind, "", (), blank()))


JOB, TARGET, GRIP, BRIDGE, OTHER = map(
    icon, ("Joint job", "Joint object", "Complete job", "Bridge object", "Other object")
)


def test_an_icon_fits_where_left_edge_is_right_edge() -> None:
    job, target = SYNTAX.find("Joint job"), SYNTAX.find("Joint object")  # R-D03, Equation (7)
    assert job and target
    assert fits(job, target)
    assert not fits(target, target)


def test_a_hole_opens_where_the_right_neighbour_does_not_fit() -> None:
    assert insert(AppFlow((GRIP,)), -1, JOB, SYNTAX).steps == (JOB, Hole(), GRIP)  # R-D03


def test_a_fitting_icon_fills_the_hole() -> None:
    flow = AppFlow((JOB, Hole(), GRIP))  # R-D19
    assert insert(flow, 0, TARGET, SYNTAX).steps == (JOB, TARGET, GRIP)
    assert insert(flow, 1, TARGET, SYNTAX).steps == (JOB, TARGET, GRIP)


def test_a_hole_may_need_several_icons() -> None:
    flow = insert(AppFlow((JOB, Hole(), GRIP)), 1, BRIDGE, SYNTAX)  # R-D19
    assert flow.steps == (JOB, BRIDGE, Hole(), GRIP)
    assert insert(flow, 1, OTHER, SYNTAX).steps == (JOB, BRIDGE, OTHER, GRIP)


def test_a_hole_opens_before_the_end_icon() -> None:
    assert insert(AppFlow(()), -1, JOB, SYNTAX).steps == (JOB, Hole())  # reading 33


def test_an_icon_that_does_not_fit_is_refused_with_what_would_fit() -> None:
    (refusal,) = refusals(AppFlow((JOB, Hole())), 1, GRIP, SYNTAX)  # R-D03, R-X01
    assert str(refusal.reason) == "a Complete job does not fit behind a Joint job"
    assert [way.args["kind"] for way in refusal.remedies] == ["Joint object", "Bridge object"]
    with pytest.raises(ValueError, match="does not fit"):
        insert(AppFlow((JOB, Hole())), 1, GRIP, SYNTAX)


@pytest.mark.parametrize("kind", ["Application start", "Application end", "Strange object"])
def test_types_that_stand_in_no_flow_are_refused(kind: str) -> None:
    assert len(refusals(AppFlow(()), -1, icon(kind), SYNTAX)) == 1  # R-D04


def test_deleting_opens_and_closes_holes() -> None:
    assert delete(AppFlow((JOB, TARGET, GRIP)), 1, SYNTAX).steps == (JOB, Hole(), GRIP)  # R-D19
    assert delete(AppFlow((JOB, Hole(), GRIP)), 0, SYNTAX).steps == (GRIP,)
    with pytest.raises(ValueError, match="hole"):
        delete(AppFlow((JOB, Hole())), 1, SYNTAX)


def test_misfits_count_the_start_and_the_end_icon() -> None:
    assert misfits(AppFlow((TARGET, GRIP, TARGET, JOB)), SYNTAX) == (0, 2, 4)
    assert misfits(AppFlow((Hole(), TARGET, icon("Strange object"), TARGET)), SYNTAX) == ()


@given(st.lists(st.tuples(st.sampled_from(PLACEABLE), st.integers(-1, 6), st.booleans()), max_size=12))
@settings(max_examples=examples(150), deadline=None)
def test_no_row_of_insertions_and_deletions_makes_two_neighbours_misfit(acts: list[tuple[str, int, bool]]) -> None:
    flow = AppFlow(())  # R-D05
    for kind, wish, inserts in acts:
        at = min(wish, len(flow.steps) - 1)
        if inserts and not refusals(flow, at, icon(kind), SYNTAX):
            flow = insert(flow, at, icon(kind), SYNTAX)
        elif not inserts and at >= 0 and isinstance(flow.steps[at], Icon):
            flow = delete(flow, at, SYNTAX)
        assert misfits(flow, SYNTAX) == ()
        holes = [isinstance(step, Hole) for step in flow.steps]
        assert not any(item and other for item, other in pairwise(holes))


# -- several targets of one job, and branches

TWICE = Icon(Onikon("twice", "Joint job", "", (), blank(), ("Joint object",)))
AND_OTHER = Icon(Onikon("both", "Joint job", "", (), blank(), ("Other object",)))
FIRST, SECOND = (Icon(Onikon(name, "Joint object", "", (), blank())) for name in ("first", "second"))
BRANCH = Branch((AppFlow((GRIP,)), AppFlow(())))


def test_behind_a_target_stands_the_next_one_its_job_wants() -> None:
    assert misfits(AppFlow((AND_OTHER, TARGET, OTHER, GRIP)), SYNTAX) == ()  # R-D13
    assert misfits(AppFlow((AND_OTHER, TARGET, GRIP)), SYNTAX) == (2,)
    assert misfits(AppFlow((JOB, TARGET, OTHER, GRIP)), SYNTAX) == (2,)
    (refusal,) = refusals(AppFlow((AND_OTHER, TARGET, Hole())), 1, GRIP, SYNTAX)
    assert refusal.remedies == (Reason.of("rules.insert", kind="Other object"),)


def test_targets_are_inserted_one_by_one() -> None:
    flow = insert(AppFlow((GRIP,)), -1, TWICE, SYNTAX)  # R-D13, R-D19
    assert flow.steps == (TWICE, Hole(), GRIP)
    flow = insert(flow, 0, SECOND, SYNTAX)
    assert flow.steps == (TWICE, SECOND, Hole(), GRIP)
    assert insert(flow, 0, FIRST, SYNTAX).steps == (TWICE, FIRST, SECOND, GRIP)
    assert insert(flow, 1, FIRST, SYNTAX).steps == (TWICE, SECOND, FIRST, GRIP)
    assert insert(AppFlow((TWICE, FIRST, Hole())), 1, SECOND, SYNTAX).steps == (TWICE, FIRST, SECOND)


def test_a_target_that_is_deleted_leaves_a_hole_where_the_last_one_is_missing() -> None:
    whole = AppFlow((TWICE, FIRST, SECOND, GRIP))  # R-D13, R-D19
    assert delete(whole, 1, SYNTAX).steps == (TWICE, SECOND, Hole(), GRIP)
    assert delete(whole, 2, SYNTAX).steps == (TWICE, FIRST, Hole(), GRIP)
    assert delete(AppFlow((TWICE, FIRST, SECOND)), 1, SYNTAX).steps == (TWICE, SECOND, Hole())
    both = AppFlow((AND_OTHER, TARGET, OTHER, GRIP))
    assert delete(both, 1, SYNTAX).steps == (AND_OTHER, Hole(), OTHER, GRIP)
    assert misfits(delete(both, 1, SYNTAX), SYNTAX) == ()


targets = st.lists(st.sampled_from([0, 1, 2, 3]), max_size=8)


@given(targets)
@settings(max_examples=examples(400), deadline=None)
def test_whatever_is_inserted_and_deleted_a_flow_without_holes_fits_and_has_its_targets(draws: list[int]) -> None:
    flow = AppFlow((AND_OTHER, Hole(), GRIP))  # R-D13, R-D19
    for number, draw in enumerate(draws):
        at = draw % len(flow.steps)
        if number % 3 == 2 and not isinstance(flow.steps[at], Hole):
            flow = delete(flow, at, SYNTAX)
            continue
        for step in (TARGET, OTHER, TWICE, BRANCH, GRIP):
            if not refusals(flow, at - 1, step, SYNTAX):
                flow = insert(flow, at - 1, step, SYNTAX)
                break
        assert misfits(flow, SYNTAX) == ()
        assert not any(isinstance(a, Hole) and isinstance(b, Hole) for a, b in pairwise(flow.steps))


def test_a_branch_has_the_edges_of_a_no_op() -> None:
    assert insert(AppFlow((GRIP, GRIP)), 0, BRANCH, SYNTAX).steps == (GRIP, BRANCH, GRIP)  # R-D13
    assert misfits(AppFlow((BRANCH, JOB, TARGET, BRANCH)), SYNTAX) == ()
    assert misfits(AppFlow((JOB, BRANCH)), SYNTAX) == (1,)
    (refusal,) = refusals(AppFlow((JOB, Hole())), 0, BRANCH, SYNTAX)
    assert str(refusal.reason) == "a branch does not fit behind a Joint job"
    assert delete(AppFlow((GRIP, BRANCH, GRIP)), 1, SYNTAX).steps == (GRIP, GRIP)
