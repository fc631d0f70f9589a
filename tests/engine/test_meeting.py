from kit.plans import build
from onika.engine.meeting import Meetings
from onika.engine.program import FlowProgram
from onika.wire.plan import Do, Halt, Meet

FREE = build.job("a", trigger="a")


def meetings(*tags):
    """Meetings of flows that each have these tags, in this order."""
    programs = []
    for own in tags:
        script = [*(Meet(tag) for tag in own.split()), Do(0), Halt()]
        programs.append(FlowProgram(build.plan(build.flow([FREE], script)).flows[0]))
    return Meetings(programs)


def test_a_flow_waits_for_all_others_in_whose_programs_the_tag_stands():  # R-E04, reading 26
    made = meetings("meet", "", "meet meet", "meet")
    assert made.arrive(3, "meet") == []
    assert made.absent(3) == [0, 2]
    assert made.waits_at(3) == "meet"
    assert made.waits_at(0) == ""


def test_the_last_to_come_takes_all_with_it_in_their_order():  # R-E04
    made = meetings("meet", "meet", "meet")
    assert made.arrive(2, "meet") == []
    assert made.arrive(0, "meet") == []
    assert made.absent(2) == [1]
    assert made.arrive(1, "meet") == [0, 1, 2]
    assert [made.waits_at(flow) for flow in range(3)] == ["", "", ""]


def test_a_tag_of_one_flow_holds_nobody():  # reading 27
    assert meetings("meet", "").arrive(0, "meet") == [0]


def test_a_flow_at_another_tag_is_absent():
    made = meetings("meet later", "later meet")
    assert made.arrive(0, "meet") == []
    assert made.arrive(1, "later") == []
    assert (made.absent(0), made.absent(1)) == ([1], [0])


def test_the_second_visit_of_one_meets_the_second_of_the_other():  # reading 26
    made = meetings("meet", "meet")
    made.arrive(0, "meet")
    made.let_pass(0)
    assert made.arrive(0, "meet") == []
    assert made.arrive(1, "meet") == [1]
    assert made.absent(0) == [1]
    assert made.arrive(1, "meet") == [0, 1]


def test_who_was_let_pass_has_been_there():  # reading 26
    made = meetings("meet", "meet")
    made.arrive(0, "meet")
    made.let_pass(0)
    assert made.waits_at(0) == ""
    assert made.arrive(1, "meet") == [1]


def test_who_was_withdrawn_has_not_been_there():  # reading 26
    made = meetings("meet", "meet")
    made.arrive(0, "meet")
    made.withdraw(0)
    assert made.waits_at(0) == ""
    assert made.arrive(1, "meet") == []
    assert made.arrive(0, "meet") == [0, 1]


def test_the_visits_of_a_nested_application_are_counted_anew_each_time_and_those_of_others_are_not():
    made = meetings("nested other", "nested other")
    for tag in ("nested", "other"):
        made.arrive(0, tag)
        made.let_pass(0)
    made.begin_anew(["nested"])
    assert made.arrive(1, "nested") == []
    made.withdraw(1)
    assert made.arrive(1, "other") == [1]
