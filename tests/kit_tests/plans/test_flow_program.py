from kit.plans.flow_program import bottom, branch, nested, program, top
from onika.wire.plan import Again, Choose, Do, Fork, Halt, Join, Jump, Meet, Unless


def test_parts_follow_each_other_and_a_halt_ends_them():
    assert program() == (Halt(),)
    assert program(Meet("a"), Do(0), Halt(), Do(1)) == (Meet("a"), Do(0), Halt(), Do(1), Halt())


def test_a_bottom_test_loop_leads_back_to_its_first_part():
    assert program(Do(0), bottom("l", Do(1), Do(2))) == (Do(0), Do(1), Do(2), Again("l", 1), Halt())
    assert program(bottom("l", Do(0), condition="X")) == (Do(0), Again("l", 0, "X"), Halt())


def test_a_top_test_loop_leads_past_its_body_or_back_to_its_test():
    assert program(Do(0), top("l", Do(1), Do(2))) == (Do(0), Do(1), Unless("l", 5), Do(2), Jump(1, "l"), Halt())
    assert program(top("l", Do(0), condition="X")) == (Do(0), Unless("l", 3, "X"), Jump(0, "l"), Halt())


def test_a_branch_leads_to_one_of_its_ways_and_each_way_to_its_end():
    assert program(branch([Do(0)], [], [Do(1), Do(2)], name="sort"), Do(3)) == (
        *(Choose((1, 3, 4), (), "sort"), Do(0), Jump(7), Jump(7), Do(1), Do(2), Jump(7)),
        *(Do(3), Halt()),
    )
    assert program(branch([Do(0)], [Do(1)], conditions=("X",)))[0] == Choose((1, 3), ("X",))


def test_a_nested_application_begins_flows_and_awaits_them():
    fork = Fork(((1, 0), (2, 4)), "both")
    assert program(nested([(1, 0), (2, 4)], Do(0), name="both")) == (fork, Do(0), Join((1, 2)), Halt())


def test_parts_nest_with_their_places():
    script = program(Do(0), bottom("outer", branch([top("inner", Do(1))], [Do(2)])))
    assert script == (
        *(Do(0), Choose((2, 6)), Do(1), Unless("inner", 5), Jump(2, "inner"), Jump(8), Do(2), Jump(8)),
        *(Again("outer", 1), Halt()),
    )
