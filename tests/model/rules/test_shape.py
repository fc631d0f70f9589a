import pytest
from tests.model.rules.upper import HOLE, MOVE, POSE, SYNTAX, THERE, VIA, branch, flow, icon, job, outline, texts

from onika.model.application import AppFlow
from onika.model.rules.shape import faults


def result(*flows: AppFlow) -> list[str]:
    return [text.partition(": ")[2] for text in texts(faults(outline(*flows), SYNTAX))]


def test_a_whole_application_has_no_faults() -> None:
    empty_arm = branch(flow(), flow(MOVE, THERE))  # R-E01, R-D13
    assert result(flow(MOVE, THERE, empty_arm, VIA, THERE, POSE, job())) == []


def test_an_application_needs_flows_and_flows_need_actions() -> None:
    assert result() == ["expected at least one flow, found none"]
    assert result(flow(job()), flow()) == ["expected an action in flow 1, found none"]


def test_a_fault_in_a_branch_is_named_with_its_path() -> None:
    assert result(flow(job(), branch(flow(job()), flow(MOVE, job(line=1))))) == [
        "expected a Joint object behind it, found none behind `move`, step 0 of flow 0, step 1, branch 1",
        (
            "expected edges that fit"
            ", found `j` (Complete job) behind `move` (Joint job), at step 1 of flow 0, step 1, branch 1"
        ),
    ]


def test_every_target_that_lacks_is_named() -> None:
    assert [text for text in result(flow(VIA, HOLE, job())) if "behind it" in text] == []  # R-D13
    assert result(flow(VIA, THERE, job())) == [
        "expected a Cartesian object behind it, found none behind `via`, step 0 of flow 0",
        "expected edges that fit, found `j` (Complete job) behind `there` (Joint object), at step 2 of flow 0",
    ]
    assert len(result(flow(VIA, job()))) == 3


def test_targets_in_the_wrong_order_do_not_fit() -> None:
    assert result(flow(VIA, POSE, THERE)) == [
        "expected edges that fit, found `pose` (Cartesian object) behind `via` (Joint job), at step 1 of flow 0",
        "expected edges that fit, found `there` (Joint object) behind `pose` (Cartesian object), at step 2 of flow 0",
    ]


def test_a_target_too_many_is_named() -> None:
    assert result(flow(VIA, THERE, POSE, POSE))[0] == (
        "expected an action that takes this target, found none before `pose`, step 3 of flow 0"
    )


@pytest.mark.parametrize("conditions", [("A == 1", "A == 2"), ("A == 1",) * 3])
def test_a_branch_has_one_condition_fewer_than_flows(conditions: tuple[str, ...]) -> None:
    step = branch(flow(job()), flow(), conditions=conditions)
    assert result(flow(step)) == [
        f"expected 1 conditions of a branch, or none, found {len(conditions)} at a branch of 2, step 0 of flow 0"
    ]


def test_an_unknown_target_is_named() -> None:
    assert result(flow(job(), icon("x", "Odd object"))) == [
        "expected a type the syntax defines, found Odd object of `x`, step 1 of flow 0"
    ]
