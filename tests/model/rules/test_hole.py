from tests.model.rules.upper import HOLE, MOVE, REACH, SYNTAX, THERE, VIA, branch, flow, job, nop, outline, part, texts

from onika.model.application import AppFlow, Icon
from onika.model.rules.hole import faults, fillings, holes, open_types


def types(*steps: object) -> list[tuple[str, ...]]:
    return [hole.types for hole in holes(outline(flow(*steps)), SYNTAX)]  # type: ignore[arg-type]


def test_a_hole_wants_the_target_of_the_job_left_of_it_or_an_action() -> None:
    assert types(MOVE, HOLE, job(), HOLE) == [("Joint object",), ()]  # reading 32


def test_a_hole_may_want_several_targets_of_a_job() -> None:
    assert types(VIA, HOLE) == [("Joint object", "Cartesian object")]  # R-D13
    assert types(VIA, THERE, HOLE) == [("Cartesian object",)]


def test_holes_of_all_flows_and_branches_count_together_each_type_once() -> None:
    result = outline(flow(REACH, HOLE), flow(job(), branch(flow(MOVE, HOLE), flow(REACH, HOLE))))  # reading 32
    assert open_types(result, SYNTAX) == ("Cartesian object", "Joint object")


def test_an_application_by_itself_may_have_no_hole_a_nested_one_those_for_targets() -> None:
    steps = flow(MOVE, HOLE, job(), HOLE)
    assert texts(faults(outline(steps), SYNTAX)) == [
        "work.appl: expected an application without holes, found a hole, step 1 of flow 0",
        "work.appl: expected an application without holes, found a hole, step 3 of flow 0",
    ]
    assert texts(faults(outline(steps, is_nested=True), SYNTAX)) == [
        "work.appl: expected an action in place of a hole, found a hole, step 3 of flow 0 of `work`"
    ]


def filled(icon: Icon, *inner: AppFlow) -> list[str]:
    outer = outline(flow(nop(), icon))
    passage = outer.passages[0]
    return texts(fillings(outer, outline(*inner, name="part"), (passage, passage.actions[1]), SYNTAX))


def test_the_targets_of_a_nested_application_fill_the_holes_of_their_types() -> None:
    both = flow(MOVE, HOLE, REACH, HOLE, MOVE, HOLE)  # R-D09, R-D13
    assert filled(part("part", "Joint", "Cartesian object"), both) == []
    assert filled(part("part", "Cartesian", "Joint object"), both) == []
    assert filled(part("part", "Joint"), both) == [
        "work.appl: expected a Cartesian object for the holes of `part`, found none behind `part`, step 1 of flow 0"
    ]
    assert len(filled(part(), both)) == 2


def test_a_target_that_fills_nothing_is_noted() -> None:
    assert filled(part("part", "Joint"), flow(job())) == [
        (
            "*work.appl: expected only targets for the holes of `part`"
            ", found a Joint object behind `part`, step 1 of flow 0"
        )
    ]
    assert filled(part("part", "Joint", "Joint object"), flow(MOVE, HOLE)) == [
        "*work.appl: expected one Joint object for the holes of `part`, found another behind `part`, step 1 of flow 0"
    ]
