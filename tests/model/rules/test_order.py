from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.rules.order import Ports, constant_order, rank
from onika.model.task import Task

MOVE = Ports("move", inconst=("NDOF",), invar=("Q_MEZ",), outvar=("Q_REF",))
PD = Ports("pd", inconst=("NDOF",), invar=("Q_REF", "Q_MEZ", "Q^_MEZ"), outvar=("TAU",))
RATE = Ports("rate", invar=("Q_MEZ",), outvar=("Q^_MEZ",))
PUMA = Ports("puma", outconst=("NDOF",), invar=("TAU",), outvar=("Q_MEZ",))


def ordered(ranks):
    return sorted(ranks, key=ranks.__getitem__)


def test_writers_run_before_readers_and_hardware_runs_first():  # law 1
    assert ordered(rank([PD, RATE, MOVE, PUMA], {"puma"})) == ["puma", "rate", "move", "pd"]


def test_ranks_count_from_0_without_gaps():
    assert sorted(rank([PD, RATE, MOVE, PUMA], {"puma"}).values()) == [0, 1, 2, 3]


def test_a_loop_without_hardware_keeps_the_order_of_the_file():  # reading 14
    a = Ports("a", invar=("Z",), outvar=("X",))
    b = Ports("b", invar=("Y",), outvar=("Z",))
    c = Ports("c", invar=("X",), outvar=("Y",))
    assert ordered(rank([c, a, b], set())) == ["c", "a", "b"]


def test_a_task_behind_a_loop_runs_after_all_of_it():
    after = Ports("after", invar=("X",), outvar=())
    a = Ports("a", invar=("Y",), outvar=("X",))
    b = Ports("b", invar=("X",), outvar=("Y",))
    before = Ports("before", outvar=("Y",))
    assert ordered(rank([after, a, b, before], set())) == ["before", "a", "b", "after"]


def test_two_hardware_tasks_in_one_loop_both_are_sources():
    left = Ports("left", invar=("U",), outvar=("Q",))
    right = Ports("right", invar=("Q",), outvar=("R",))
    law = Ports("law", invar=("R", "Q"), outvar=("U",))
    assert ordered(rank([law, right, left], {"left", "right"})) == ["right", "left", "law"]


def test_a_task_that_reads_what_it_writes_is_no_loop():
    own = Ports("own", invar=("X",), outvar=("X",))
    reader = Ports("reader", invar=("X",))
    assert ordered(rank([reader, own], set())) == ["own", "reader"]


def test_tasks_that_do_not_depend_on_each_other_keep_the_order_of_the_file():
    assert ordered(rank([Ports("c"), Ports("a"), Ports("b")], set())) == ["c", "a", "b"]


def test_of_nothing_there_is_no_order():
    assert rank([], set()) == {}
    assert constant_order([]) == ([], [])


def test_constants_do_not_order_a_cycle():
    reader = Ports("reader", inconst=("NDOF",))
    assert ordered(rank([reader, Ports("writer", outconst=("NDOF",))], set())) == ["reader", "writer"]


def test_suppliers_of_constants_are_spawned_before_their_consumers():  # law 10
    tool = Ports("tool", inconst=("NDOF",), outconst=("TOOL",))
    reach = Ports("reach", inconst=("TOOL", "NDOF"))
    assert constant_order([reach, tool, PUMA]) == (["puma", "tool", "reach"], [])


def test_variables_do_not_order_spawning():
    assert constant_order([PD, RATE]) == (["pd", "rate"], [])


def test_a_first_value_counts_as_a_constant():  # law 10, reading 7
    both_out = Ports("writer", outconst=("X",), outvar=("X",))
    both_in = Ports("reader", inconst=("X",), invar=("X",))
    assert constant_order([both_in, both_out])[0] == ["writer", "reader"]


def test_a_cycle_of_constants_is_found_and_named():  # law 10
    a = Ports("a", inconst=("Y",), outconst=("X",))
    b = Ports("b", inconst=("X",), outconst=("Y",))
    after = Ports("after", inconst=("X",))
    assert constant_order([after, b, a, Ports("else")]) == (["b", "a", "after", "else"], [["b", "a"]])


def test_a_task_that_supplies_its_own_constant_is_a_cycle():
    assert constant_order([Ports("own", inconst=("X",), outconst=("X",))]) == (["own"], [["own"]])


def test_a_constant_that_nobody_supplies_orders_nothing():
    assert constant_order([MOVE, PD]) == (["move", "pd"], [])


def test_ports_have_the_names_of_the_table_not_those_of_the_code():  # R-C07
    task = Task(
        "t", "t", aliases=(("A", "B"), ("B", "A")), inconst=("A",), outconst=("C",), invar=("B",), outvar=("D",)
    )
    assert Ports.of(task) == Ports("t", inconst=("B",), outconst=("C",), invar=("A",), outvar=("D",))


def test_a_long_chain_is_ordered():
    chain = [Ports(str(i), invar=(f"X{i}",), outvar=(f"X{i + 1}",)) for i in range(3000)]
    assert ordered(rank(chain[::-1], set())) == [str(i) for i in range(3000)]


svars = st.lists(st.sampled_from("ABCDE"), max_size=2, unique=True).map(tuple)
tasks = st.lists(st.tuples(svars, svars), max_size=7).map(
    lambda lists: [Ports(str(i), invar=reads, outvar=writes) for i, (reads, writes) in enumerate(lists)]
)


@settings(max_examples=examples(150), deadline=None)
@given(tasks, st.sets(st.integers(0, 6).map(str), max_size=2))
def test_of_two_tasks_the_writer_runs_first_unless_they_lie_on_a_loop(tasks, hardware):  # law 1
    onward = {t.name: {o.name for o in tasks if o.name not in hardware and {*t.outvar} & {*o.invar}} for t in tasks}
    for _ in tasks:  # all that can be reached
        onward = {name: result | {far for near in result for far in onward[near]} for name, result in onward.items()}
    ranks = rank(tasks, hardware)
    for place, first in enumerate(tasks):
        for second in tasks[place + 1 :]:
            a, b = first.name, second.name
            forth, back = b in onward[a], a in onward[b]
            if forth != back:
                assert (ranks[a] < ranks[b]) == forth
            elif forth:
                assert ranks[a] < ranks[b]


@settings(max_examples=examples(50), deadline=None)
@given(tasks)
def test_the_order_of_constants_is_that_of_variables_with_the_words_exchanged(tasks):
    constants = [Ports(task.name, inconst=task.invar, outconst=task.outvar) for task in tasks]
    order, cycles = constant_order(constants)
    assert order == ordered(rank(tasks, set()))
    for cycle in cycles:
        for name in cycle:
            task = tasks[int(name)]
            assert any({*task.invar} & {*tasks[int(other)].outvar} for other in cycle)
