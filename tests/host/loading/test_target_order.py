from onika.host.loading.target_order import RELATIVE, UNKNOWN, in_order
from onika.wire.plan import Again, Do, Halt, Meet, PlannedAction, PlannedFlow, Rest
from onika.wire.request import TargetValues


def flow(*movers, program=()):
    """Actions, each with the tasks that it needs."""
    actions = tuple(PlannedAction(f"a{k}", "job", None, "f.appl", tasks, (), "") for k, tasks in enumerate(movers))
    return PlannedFlow("flow0", (), actions, program)


def targets(**kinds):
    """By action, `a0="relative object"`; each with its number as its value."""
    return [TargetValues(0, int(name[1:]), kind, (float(name[1:]),)) for name, kind in kinds.items()]


ARM, HAND = ("arm", "move"), ("hand", "close")
ABSOLUTE = "cartesian object"


def test_without_a_relative_target_all_are_asked_about_as_they_are():  # law 26
    given = targets(a1=ABSOLUTE, a0="joint object")
    assert in_order(flow(ARM, ARM), "arm", given) == ([(ABSOLUTE, [1.0]), ("joint object", [0.0])], [0, 1])


def test_a_relative_target_stands_behind_the_one_before_it_whatever_the_hand_does_between():  # R-D25
    moves = flow(ARM, HAND, ARM, program=(Do(0), Meet("here"), Do(1), Rest(1), Do(2), Halt()))
    questions, places = in_order(moves, "arm", targets(a2=RELATIVE, a0=ABSOLUTE))
    assert questions[:2] == [(ABSOLUTE, [0.0]), (RELATIVE, [2.0])]
    assert places == [1, 0]


def test_without_a_program_actions_follow_each_other_as_they_stand():  # R-D25
    questions, places = in_order(flow(ARM, HAND, ARM), "arm", targets(a0=ABSOLUTE, a2=RELATIVE))
    assert (questions, places) == ([(ABSOLUTE, [0.0]), (RELATIVE, [2.0])], [0, 1])


def test_what_moves_the_arm_without_a_target_leaves_it_nobody_knows_where():  # R-D25
    questions, places = in_order(flow(ARM, ARM, ARM), "arm", targets(a0=ABSOLUTE, a2=RELATIVE))
    assert questions == [(ABSOLUTE, [0.0]), UNKNOWN, (RELATIVE, [2.0])]
    assert places == [0, 2]


def test_behind_a_loop_nobody_knows_how_often_it_went_on():  # R-D25
    program = (Do(0), Do(1), Again("up", 1), Do(2), Halt())
    given = targets(a0=ABSOLUTE, a1=RELATIVE, a2=RELATIVE)
    questions, places = in_order(flow(ARM, ARM, ARM, program=program), "arm", given)
    assert [questions[place][1] for place in places] == [[0.0], [1.0], [2.0]]
    assert questions[places[2] - 1] == UNKNOWN and questions[places[1] - 1] == (ABSOLUTE, [0.0])


def test_a_target_that_no_program_comes_to_is_asked_about_by_itself():
    questions, places = in_order(flow(ARM, ARM, program=(Do(0), Halt())), "arm", targets(a0=ABSOLUTE, a1=RELATIVE))
    assert questions[places[1] - 1] == UNKNOWN and questions[places[1]] == (RELATIVE, [1.0])
