from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.plans import build
from kit.plans.flow_program import bottom, branch, program, top
from onika.engine.lookahead import ways
from onika.engine.program import FlowProgram
from onika.engine.walk import FinishValue, walk
from onika.wire.plan import Do, Rest

JOB = build.job("move", trigger="move")
NOTHING = frozenset()


def made(script, noops=()):
    actions = 1 + max(instruction.action for instruction in script if isinstance(instruction, Do))
    jobs = [build.noop() if index in noops else JOB for index in range(actions)]
    return FlowProgram(build.plan(build.flow(jobs, script)).flows[0])


def places(script, pc=1, leaving=NOTHING, noops=()):
    return [(choice, loop, way.pc) for choice, loop, way in ways(made(script, noops), pc, leaving)]


def test_a_way_that_no_value_changes_is_one():
    assert places(program(Do(0), Do(1))) == [(None, None, 1)]


def test_a_test_makes_two_ways_and_a_branch_as_many_as_it_has_flows():
    assert places(program(bottom("round", Do(0)), Do(1))) == [(None, False, 2), (None, True, 0)]
    assert places(program(Do(0), branch([Do(1)], [Do(2)]))) == [(0, None, 2), (1, None, 4)]


def test_a_test_behind_a_no_op_makes_no_ways():  # R-D11
    assert places(program(bottom("round", Do(0), Do(1)), Do(2)), noops=[1]) == [(None, None, 0)]


def test_a_loop_that_is_to_be_left_makes_no_ways():
    assert places(program(bottom("round", Do(0)), Do(1)), leaving=frozenset({"round"})) == [(None, None, 2)]


def test_where_a_condition_decides_nothing_is_foreseen():
    assert places(program(bottom("round", Do(0), condition="X"), Do(1))) == []
    assert places(program(Do(0), Rest(-1, "X"), Do(1))) == []


def test_where_a_condition_decides_on_one_way_the_other_is_foreseen():
    assert places(program(Do(0), branch([Do(1)], [Rest(-1, "X"), Do(2)]))) == [(0, None, 2)]


def test_a_way_that_warns_is_not_foreseen():  # reading 20
    script = program(Do(0), branch([branch([Do(1)], [Do(2)])], [Do(3)], [Do(4)]))
    assert [choice for choice, _, _ in places(script)] == [0, 1, 2]
    two = program(Do(0), branch([Do(1)], [Do(2)], [branch([Do(3)], [Do(4)])]))
    assert [choice for choice, _, _ in places(two)] == [0, 1]


def test_a_way_without_an_end_is_not_foreseen():
    assert places(program(Do(0), bottom("round", Do(1))), noops=[1]) == []


def test_no_more_ways_are_foreseen_than_it_is_worth():
    script = program(Do(0), branch(*[[Do(index)] for index in range(1, 30)]))
    assert [choice for choice, _, _ in places(script)] == [0, 1, 2, 3]


def parts(depth=2):
    leaf = st.just("do")
    if depth == 0:
        return st.lists(leaf, min_size=1, max_size=2)
    inner = parts(depth - 1)
    block = st.one_of(
        leaf,
        st.tuples(st.sampled_from(["bottom", "top"]), inner),
        st.tuples(st.just("branch"), st.lists(inner, min_size=1, max_size=3)),
    )
    return st.lists(block, min_size=1, max_size=3)


class Counted:
    """Makes a program of drawn parts; every action and loop is a new one."""

    def __init__(self):
        self.actions = 0
        self.loops = 0

    def do(self):
        self.actions += 1
        return Do(self.actions - 1)

    def parts(self, drawn):
        return [self.part(part) for part in drawn]

    def part(self, part):
        if part == "do":
            return self.do()
        kind, inner = part
        if kind == "branch":
            return branch(*[self.parts(each) for each in inner])
        self.loops += 1
        name = f"loop {self.loops}"
        return bottom(name, *self.parts(inner)) if kind == "bottom" else top(name, self.do(), *self.parts(inner))


@given(parts(), st.data())
@settings(max_examples=examples(300), deadline=None)
def test_whatever_is_foreseen_comes_true_and_no_value_fits_two_ways(drawn, data):
    counted = Counted()
    script = program(counted.do(), *counted.parts(drawn))
    noops = data.draw(st.sets(st.integers(0, counted.actions - 1)))
    loops = st.sets(st.sampled_from([f"loop {number}" for number in range(1, counted.loops + 1)] or ["none"]))
    leaving = frozenset(data.draw(loops))
    whole = made(script, noops)
    pc = data.draw(st.integers(0, len(script) - 2))
    value = FinishValue(data.draw(st.integers(0, 4)), loop=data.draw(st.booleans()))
    fits = [
        way
        for choice, loop, way in ways(whole, pc, leaving)
        if choice in (None, value.choice) and loop in (None, value.loop)
    ]
    assert len(fits) <= 1
    really = walk(whole, pc, value, leaving, lambda _condition: False, lambda _action: False)
    for way in fits:
        assert (way.pc, way.left, way.passed) == (really.pc, really.left, really.passed)
    if not fits:
        assert really.notes or really.is_endless or value.choice > 2
