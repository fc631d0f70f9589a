from tests.model.rules.upper import SYNTAX, application, branch, flow, job, nop, outline

from onika.model.rules.outline import Outline, shown
from onika.words.fault import Place
from onika.words.reason import Reason


def test_flows_of_branches_stand_behind_the_flow_they_are_in_with_their_paths() -> None:
    inner = branch(flow(nop()), flow(branch(flow(job("deep")))))  # R-D13
    result = outline(flow(job("a"), inner), flow(job("b")))
    assert [(passage.path, passage.number, passage.is_inner) for passage in result.passages] == [
        ("flow 0", 0, False),
        ("flow 0, step 1, branch 0", 0, True),
        ("flow 0, step 1, branch 1", 0, True),
        ("flow 0, step 1, branch 1, step 0, branch 0", 0, True),
        ("flow 1", 1, False),
    ]
    assert [action.icon.onikon.name for _, action in result.actions()] == ["a", "nop", "deep", "b"]
    assert [passage.path for passage in result.of_flow(1)] == ["flow 1"]


def test_a_step_is_named_with_its_position_its_flow_and_the_nested_application() -> None:
    steps = flow(job("open", line=7))  # R-E01
    for is_nested, name in ((False, "flow 0"), (True, "flow 0 of `part`")):
        result = outline(steps, name="part", is_nested=is_nested)
        assert str(result.at(result.passages[0], 0)) == f"`open`, step 0 of {name}"
        assert result.place(steps.steps[0]) == Place("part.appl", 7)
        assert result.fault(None, Reason.of("rules.no_flow")).place == Place("part.appl")


def test_a_branch_is_named_by_its_flows() -> None:
    assert str(shown(branch(flow(), flow()))) == "a branch of 2"


def test_an_application_without_flows_has_no_passages() -> None:
    assert Outline.of(application(), SYNTAX, "f").passages == ()
