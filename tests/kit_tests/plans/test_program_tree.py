"""Trees become the programs that they are drawn as."""

import pytest

from kit.plans.program_tree import Act, Loop, Pick, Side, acts, engine_for, planned
from onika.wire.plan import Again, Choose, Do, Fork, Halt, Join, Jump, Meet, Rest, Unless

NOOP = Act(tasks=(), is_noop=True)


@pytest.mark.parametrize(
    ("tree", "program"),
    [
        ((Act("a"), Act(breakpoint="")), (Meet("a"), Do(0), Do(1), Rest(1), Halt())),
        ((Act(), Loop("l", (Act(), Act()))), (Do(0), Do(1), Do(2), Again("l", 1), Halt())),
        ((Loop("l", (Act(), Act()), True),), (Do(0), Unless("l", 4), Do(1), Jump(0, "l"), Halt())),
        ((Pick(((Act(),), (), (NOOP,))),), (Choose((1, 3, 4)), Do(0), Jump(6), Jump(6), Do(1), Jump(6), Halt())),
    ],
)
def test_a_tree_is_laid_out_as_a_program(tree, program):
    assert planned(tree).flows[0].program == program


def test_further_flows_of_a_nested_application_are_flows_of_their_own():  # R-D13
    made = planned((Act(), Side(((Act("x a"),), (Act("x a"), Act())))), (Act(),))
    assert made.flows[0].program == (Do(0), Fork(((2, 0),)), Meet("x a"), Do(1), Join((2,)), Halt())
    assert (made.flows[2].parent, made.flows[2].program) == (0, (Meet("x a"), Do(0), Do(1), Halt()))


def test_the_engine_takes_what_was_made_and_counts_the_same_actions():
    tree = (Act(), Loop("l", (NOOP, Act())), Pick(((Act(),), ())), Side(((Act(),), (Act(),))))
    made = planned(tree)
    engine_for(made)
    assert len(acts(tree)) == len(made.flows[0].actions) == 5
