import pytest

from kit.plans import build
from kit.plans.flow_program import bottom, branch, nested, program, top
from onika.engine.program import FlowProgram, ProgramLoop, straight
from onika.wire.plan import Again, Choose, Do, Fork, Halt, Join, Jump, Meet, Rest, Unless

JOB = build.job("move", trigger="move")


def made(*script, actions=None):
    count = actions if actions is not None else sum(isinstance(instruction, Do) for instruction in script)
    return FlowProgram(build.plan(build.flow([JOB] * count, script)).flows[0])


def test_actions_without_a_program_follow_each_other_with_their_tags_and_breakpoints():
    jobs = [JOB, build.job("move", synch_tag="meet"), build.job("move", marker=True)]
    planned = build.plan(jobs).flows[0]
    expected = (Do(0), Meet("meet"), Do(1), Do(2), Rest(2), Halt())
    assert straight(planned.actions) == FlowProgram(planned).instructions == expected
    assert straight(()) == (Halt(),)


def test_an_action_begins_at_its_tag():
    assert made(Do(0), Meet("a"), Do(1), Rest(1), Do(2), Halt()).entries == {0: 0, 1: 1, 2: 4}


def test_the_breakpoints_behind_single_actions_are_known_with_their_conditions():
    assert made(Do(0), Rest(0), Do(1), Rest(1, "X > 1"), Rest(-1), Halt()).breakpoints == {0: "", 1: "X > 1"}


def test_loops_are_known_from_their_first_to_their_last_instruction():
    script = program(bottom("outer", Do(0), top("inner", Do(1), Do(2))), Do(3))
    assert set(made(*script).loops) == {ProgramLoop("outer", 0, 5), ProgramLoop("inner", 1, 4)}


@pytest.mark.parametrize(
    ("place", "names"), [(0, ["outer"]), (1, ["outer", "inner"]), (4, ["outer", "inner"]), (5, ["outer"]), (6, [])]
)
def test_the_loops_around_a_place_are_named_outermost_first(place, names):
    script = program(bottom("outer", Do(0), top("inner", Do(1), Do(2))), Do(3))
    assert [loop.name for loop in made(*script).loops_at(place)] == names


def test_loops_that_begin_at_one_place_are_named_outermost_first():
    script = program(bottom("outer", bottom("inner", Do(0)), Do(1)))
    assert [loop.name for loop in made(*script).loops_at(0)] == ["outer", "inner"]


def test_a_jump_out_of_a_branch_is_no_loop():
    assert made(*program(Do(0), branch([Do(1)], [Do(2)]))).loops == ()


def test_a_place_belongs_to_the_stretch_up_to_its_halt():
    stretches = made(Do(0), Halt(), Do(1), Do(2), Halt())
    assert [stretches.stretch(place) for place in range(5)] == [0, 0, 1, 1, 1]
    assert stretches.end == 4


def test_a_place_between_fork_and_join_stands_in_a_nested_parallel_application():
    script = program(Do(0), nested([(1, 0)], Do(1), nested([(2, 0)], Do(2))), Do(3))
    inside = [made(*script).parallel_at(place) for place in range(len(script))]
    assert inside == [(), (), (1,), (1,), (3, 1), (3, 1), (1,), (), ()]


def test_the_tags_are_named_once_each_in_their_order_and_by_stretch():
    stretches = made(Meet("b"), Do(0), Meet("a"), Do(1), Meet("b"), Do(2), Halt(), Meet("c"), Do(3), Halt())
    assert stretches.tags == ["b", "a", "c"]
    assert stretches.tags_from(0) == {"a", "b"}
    assert stretches.tags_from(2) == {"a", "b"}
    assert stretches.tags_from(7) == {"c"}


@pytest.mark.parametrize(
    ("script", "actions", "complaint"),
    [
        ((Do(0),), 1, "ends with a Halt"),
        ((Do(0), Jump(3), Halt()), 1, "expected a place below 3 at 1, found 3"),
        ((Do(0), Again("round", -1), Halt()), 1, "expected a place below 3 at 1, found -1"),
        ((Do(0), Unless("round", 9), Halt()), 1, "expected a place below 3 at 1, found 9"),
        ((Do(0), Choose((2, 7)), Halt()), 1, "expected a place below 3 at 1, found 7"),
        ((Do(0), Choose(()), Halt()), 1, "one condition fewer than ways at 1"),
        ((Do(0), Choose((2, 2), ("X", "Y")), Halt()), 1, "one condition fewer than ways at 1"),
        ((Do(1), Halt()), 1, "expected an action below 1 at 0, found 1"),
        ((Do(-1), Halt()), 1, "expected an action below 1 at 0, found -1"),
        ((Do(0), Halt()), 2, "a Do for each of 2 actions, found 1"),
        ((Do(0), Join((1,)), Halt()), 1, "a Fork before the Join at 1"),
        ((Do(0), Fork(((1, 0),)), Halt()), 1, "a Join for the Fork at 1"),
    ],
)
def test_a_program_that_leads_nowhere_is_refused(script, actions, complaint):
    with pytest.raises(ValueError, match=complaint):
        made(*script, actions=actions)


def test_an_action_may_stand_at_two_places_and_is_entered_at_the_first():
    assert made(Do(0), Do(1), Do(0), Halt(), actions=2).entries == {0: 0, 1: 1}
