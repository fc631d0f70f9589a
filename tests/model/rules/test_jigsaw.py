from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from onika.model.application import AppFlow, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.jigsaw import delete, fits, insert, misfits, refusals
from onika.model.syntax import IconType, Syntax

KINDS = {
    "Application start": (0, 0),
    "Application end": (0, 0),
    "Complete job": (0, 0),
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
    assert insert(AppFlow(()), -1, JOB, SYNTAX).steps == (JOB, Hole())  # decision 33


def test_an_icon_that_does_not_fit_is_refused_with_what_would_fit() -> None:
    (refusal,) = refusals(AppFlow((JOB, Hole())), 1, GRIP, SYNTAX)  # R-D03, R-X01
    assert refusal.reason == "a Complete job does not fit behind a Joint job"
    assert refusal.remedies == ("insert a Joint object", "insert a Bridge object")
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
@settings(max_examples=150, deadline=None)
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
        assert not any(one and other for one, other in pairwise(holes))
