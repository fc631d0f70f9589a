"""Applications in line: loops, branches, nested and parallel applications as the program the engine executes."""

from pathlib import Path

import pytest

from onika.desk.plan.sequence import Sequencer
from onika.model.application import AppFlow, Application, Branch, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.nesting import MOST
from onika.model.syntax import COMPLETE_APPLICATION, COMPLETE_JOB, COMPLETE_NOP
from onika.store.site import open_site
from onika.wire.plan import Again, Choose, Do, Fork, Halt, Join, Jump, Meet, Rest, Unless

SYNTAX = open_site([], {}, Path("/nowhere")).syntax()[0]


def icon(name, kind=COMPLETE_JOB, more=(), **marks):
    return Icon(Onikon(name, kind, "", (), blank(), more), **marks)


def job(name, **marks):
    return icon(name, **marks)


def nop(name="noop", **marks):
    return icon(name, COMPLETE_NOP, **marks)


def nested(name, kind=COMPLETE_APPLICATION, **marks):
    return icon(name, kind, **marks)


def application(name, *flows, parallel=False):
    return Application(name, parallel, tuple(AppFlow(tuple(flow)) for flow in flows))


def lines(*flows, parallel=False, others=()):
    sequencer = Sequencer(SYNTAX, {flow.name: flow for flow in others}, lambda name: f"{name}.appl")
    return sequencer.sequence(application("top", *flows, parallel=parallel), "top.appl")


def program(*steps, others=()):
    (line,) = lines(steps, others=others)
    return line.program


def names(line):
    return [doing.icon.onikon.name for doing in line.doings]


def test_actions_follow_each_other_with_their_breakpoints():
    assert program(job("a"), job("b", marker=True, marker_if="LAMP == 1"), nop()) == [
        Do(0), Do(1), Rest(1, "LAMP == 1"), Do(2), Halt()
    ]  # fmt: skip
    (line,) = lines([job("a"), nop()])
    assert [doing.is_noop for doing in line.doings] == [False, True]


def test_a_bottom_test_loop_goes_back_to_its_anchor():  # R-E05
    steps = (job("x"), job("anchor", while_tag="l"), job("b"), job("test", while_tag="l", while_test=True), job("y"))
    assert program(*steps) == [Do(0), Do(1), Do(2), Do(3), Again("l", 1), Do(4), Halt()]


def test_a_top_test_loop_tests_again_after_its_anchor():  # R-E05, §4.4.7.3
    steps = (job("test", while_tag="l", while_test=True, while_if="N < 3"), job("b"), job("anchor", while_tag="l"))
    assert program(*steps) == [Do(0), Unless("l", 5, "N < 3"), Do(1), Do(2), Jump(0, "l"), Halt()]


def test_a_round_meets_again_at_the_tag_of_its_anchor():  # reading 26
    flow = [job("a", while_tag="l", synch_tag="m"), job("t", while_tag="l", while_test=True)]
    first, _ = lines(flow, [job("c", synch_tag="m")], parallel=True)
    assert first.program == [Meet("m"), Do(0), Do(1), Again("l", 0), Halt()]


def test_loops_in_loops_close_inside_out():  # reading 23
    flow = [
        job("o", while_tag="outer"),
        job("i", while_tag="inner"),
        job("j", while_tag="inner", while_test=True),
        job("p", while_tag="outer", while_test=True),
    ]
    assert program(*flow) == [Do(0), Do(1), Do(2), Again("inner", 1), Do(3), Again("outer", 0), Halt()]


def test_a_tag_where_nobody_meets_is_left_out():  # reading 27
    assert program(job("a", synch_tag="m")) == [Do(0), Halt()]
    inner = application("inner", [job("b", synch_tag="m")])
    first, _ = lines([nested("inner")], [job("c")], parallel=True, others=[inner])
    assert first.program == [Do(0), Halt()]


def test_a_nested_application_stands_in_line_with_its_file_and_whence_it_comes():  # R-E06
    inner = application("inner", [job("b")])
    outer = application("outer", [nested("inner")])
    (line,) = lines([job("a"), nested("outer", marker=True), job("c")], others=[inner, outer])
    assert names(line) == ["a", "b", "c"]
    assert [doing.within for doing in line.doings] == [(), ("outer", "inner"), ()]
    assert [doing.file for doing in line.doings] == ["top.appl", "inner.appl", "top.appl"]
    assert line.program == [Do(0), Do(1), Rest(-1), Do(2), Halt()]


def test_a_conditional_application_is_a_choice_by_value():  # R-D10
    cases = application("cases", [job("zero")], [job("one"), job("more")])
    assert program(job("a"), nested("cases"), job("z"), others=[cases]) == [
        Do(0), Choose((2, 4), (), "cases"), Do(1), Jump(7), Do(2), Do(3), Jump(7), Do(4), Halt()
    ]  # fmt: skip


def test_a_branch_is_a_choice_by_conditions_and_may_be_empty():  # R-D13
    branch = Branch((AppFlow((job("b"),)), AppFlow(())), ("LAMP == 1",), line=7)
    assert program(branch, job("z")) == [
        Choose((1, 3), ("LAMP == 1",), "branch at line 7"), Do(0), Jump(4), Jump(4), Do(1), Halt()
    ]  # fmt: skip


def test_only_flow_0_of_a_conditional_application_runs_at_the_top():  # R-D10
    (line,) = lines([job("a")], [job("b")])
    assert names(line) == ["a"]


def test_an_application_within_itself_or_missing_is_passed_over():  # R-E06
    loop = application("loop", [job("a"), nested("loop")])
    assert program(nested("loop"), nested("nowhere"), others=[loop]) == [Do(0), Halt()]


def test_a_nested_parallel_application_forks_and_joins():  # R-D13
    both = application("both", [job("l", synch_tag="m")], [job("r", synch_tag="m")], parallel=True)
    main, other = lines([job("a"), nested("both"), job("z")], others=[both])
    assert (other.subsystem, other.parent) == ("flow0.1", 0)
    assert main.program == [Do(0), Fork(((1, 0),), "both"), Meet("both m"), Do(1), Join((1,)), Do(2), Halt()]
    assert other.program == [Meet("both m"), Do(0), Halt()]


def test_the_same_flow_serves_each_nested_parallel_application_in_turn():  # R-D13
    both = application("both", [job("l", synch_tag="m")], [job("r", synch_tag="m")], parallel=True)
    main, other = lines([nested("both"), nested("both")], others=[both])
    assert [instruction for instruction in main.program if isinstance(instruction, Fork)] == [
        Fork(((1, 0),), "both"),
        Fork(((1, 3),), "both"),
    ]
    assert other.program == [Meet("both m"), Do(0), Halt(), Meet("both#2 m"), Do(1), Halt()]


def test_flows_within_flows_have_their_own_subsystems():  # R-D13
    inner = application("inner", [job("b")], [job("c")], parallel=True)
    outer = application("outer", [job("a")], [nested("inner")], parallel=True)
    compiled = lines([nested("outer")], others=[inner, outer])
    assert [(line.subsystem, line.parent) for line in compiled] == [("flow0", None), ("flow0.1", 0), ("flow0.1.1", 1)]


def targets(line):
    return [tuple(target.onikon.name for target in doing.targets) for doing in line.doings]


def test_an_outer_target_fills_every_hole_of_its_type_also_in_nested_ones():  # R-D09, reading 32
    reach = application(
        "reach", [icon("jmove", "Joint job"), Hole(), icon("jmove", "Joint job"), icon("home", "Joint object")]
    )
    outer = application("outer", [nested("reach", "Joint application"), Hole()])
    (line,) = lines([nested("outer", "Joint application"), icon("there", "Joint object")], others=[reach, outer])
    assert targets(line) == [("there",), ("home",)]


def test_several_targets_are_told_apart_by_their_types():  # R-D13
    both = application("both", [icon("jmove", "Joint job"), Hole(), icon("wait", "Pause job"), Hole()])
    use = Icon(Onikon("both", "Joint application", "", (), blank(), ("Pause object",)))
    (line,) = lines([use, icon("there", "Joint object"), icon("long", "Pause object")], others=[both])
    assert targets(line) == [("there",), ("long",)]


@pytest.mark.slow
def test_a_program_that_grows_without_measure_is_given_up():
    flows = [application("a0", [job("x"), job("y")])]
    for depth in range(1, 40):
        flows.append(application(f"a{depth}", [nested(f"a{depth - 1}"), nested(f"a{depth - 1}")]))
    sequencer = Sequencer(SYNTAX, {flow.name: flow for flow in flows}, str)
    sequencer.sequence(application("top", [nested("a39")]), "top.appl")
    assert sum(len(line.doings) for line in sequencer.lines) == MOST


@pytest.mark.parametrize("count", [1, 3])
def test_every_program_ends(count):
    for line in lines(*[[job("a")]] * count, parallel=True):
        assert isinstance(line.program[-1], Halt)


def test_loops_of_what_is_no_action_and_branches_without_flows_are_passed_over():  # R-E01
    stray = icon("there", "Joint object", while_tag="l")
    (line,) = lines([stray, job("a", while_tag="l", while_test=True), Branch(()), job("b")])
    assert line.program == [Do(0), Do(1), Halt()]
