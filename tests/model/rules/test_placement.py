from dataclasses import replace

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.rules.placement import PlacedNeighbours, alias_refusals, greyed, meets_constant, refusals
from onika.model.task import Task

CUBIC = Task("cubic", "cubic", inconst=("NDOF",), invar=("Q_MEZ",), outvar=("Q_REF",))
VARS = ("A", "B", "C")


def reasons(task: Task, *placed: Task) -> list[str]:
    return [str(refusal.reason) for refusal in refusals(task, placed)]


def test_a_task_sharing_an_output_with_a_placed_task_is_refused() -> None:
    other = Task("quintic", "quintic", outvar=("Q_REF",))  # R-C07, Equation (2)
    assert reasons(other, CUBIC) == ["writes Q_REF, which `cubic` already writes"]
    assert list(map(str, refusals(other, [CUBIC])[0].remedies)) == ["replace `cubic`", "alias Q_REF", "show `cubic`"]


def test_aliased_names_count() -> None:
    aliased = Task("quintic", "quintic", aliases=(("Q_REF", "Q_GOAL"),), outvar=("Q_REF",))  # R-C07
    assert reasons(aliased, CUBIC) == []
    assert reasons(replace(aliased, aliases=(("OUT", "Q_REF"),), outvar=("OUT",)), CUBIC) != []


def test_a_task_of_the_same_name_or_module_is_refused_though_it_writes_nothing() -> None:
    logger = Task("logger", "logger", invar=("Q_MEZ",))
    assert reasons(logger, logger) == ["`logger` is placed already"]
    assert reasons(replace(logger, name="other"), logger) == ["its module `logger` is used already, by `logger`"]


def test_a_pure_outvar_may_not_meet_a_pure_inconst_either_way_round() -> None:
    writer = Task("w", "w", outvar=("NDOF",))  # R-C07, Equation (3), reading 5
    reader = Task("r", "r", inconst=("NDOF",))
    expected = ["`r` needs NDOF at initialisation, `w` gives it only while it runs"]
    assert reasons(writer, reader) == expected
    assert reasons(reader, writer) == expected


def test_tandems_are_no_conflict() -> None:
    reader = Task("r", "r", inconst=("X",))  # reading 6
    assert reasons(Task("w", "w", outconst=("X",), outvar=("X",)), reader) == []
    assert reasons(Task("w", "w", outconst=("X",)), reader) == []
    assert reasons(Task("w", "w", outvar=("X",)), Task("r", "r", inconst=("X",), invar=("X",))) == []


def test_every_reason_is_given_at_once() -> None:
    other = Task("other", "cubic", outvar=("Q_REF", "NDOF"))
    assert len(reasons(other, CUBIC, Task("q", "q", outvar=("Q_REF",)))) == 4


def test_two_outputs_aliased_to_one_variable_are_refused() -> None:
    task = Task("t", "t", aliases=(("A", "B"),), outconst=("A",), outvar=("A", "B"))  # reading 9
    assert [str(refusal.reason) for refusal in alias_refusals(task, [task])] == ["A and B of `t` would both write B"]


def test_an_alias_that_would_conflict_in_the_configuration_is_refused() -> None:
    changed = Task("t", "t", aliases=(("OUT", "Q_REF"),), outvar=("OUT",))  # reading 9
    assert len(alias_refusals(changed, [Task("t", "t", outvar=("OUT",)), CUBIC])) == 1
    assert alias_refusals(Task("t", "t", outvar=("OUT",)), [CUBIC]) == ()


ports = st.lists(st.sampled_from(VARS), unique=True).map(tuple)
tasks = st.builds(
    Task,
    st.sampled_from(["s", "t", "u"]),
    st.sampled_from(["m", "n", "o"]),
    inconst=ports,
    outconst=ports,
    invar=ports,
    outvar=ports,
)


@given(st.lists(tasks, max_size=4), st.lists(tasks, max_size=3))
@settings(max_examples=examples(200), deadline=None)
def test_the_greyed_set_is_exactly_equation_2(library: list[Task], placed: list[Task]) -> None:
    def clashes(t: Task, s: Task) -> bool:  # R-C07
        o_v = {x: set(x.outvar) - set(x.outconst) for x in (s, t)}
        i_c = {x: set(x.inconst) - set(x.invar) for x in (s, t)}
        shares = bool((set(t.outvar) | set(t.outconst)) & (set(s.outvar) | set(s.outconst)))
        return shares or s.name == t.name or s.module == t.module or bool(o_v[t] & i_c[s] or o_v[s] & i_c[t])

    by_name = {t.name: t for t in library}.values()
    expected = {t.name for t in by_name if any(clashes(t, s) for s in placed)}
    assert set(greyed(by_name, placed)) == expected


@given(tasks, tasks)
@settings(max_examples=examples(100), deadline=None)
def test_meeting_a_constant_needs_both_ends_pure(writer: Task, reader: Task) -> None:
    for svar in meets_constant(writer, reader):
        assert svar in writer.outvar and svar not in writer.outconst
        assert svar in reader.inconst and svar not in reader.invar


def plain_reasons(task: Task, other: Task) -> list[str]:
    """Equation (2) pair by pair, as it is written."""
    if task.name == other.name:
        return [f"`{task.name}` is placed already"]
    result = []
    if task.module == other.module:
        result.append(f"its module `{task.module}` is used already, by `{other.name}`")
    outputs = [set(item.svars(item.outvar + item.outconst)) for item in (task, other)]
    result += [f"writes {svar}, which `{other.name}` already writes" for svar in sorted(outputs[0] & outputs[1])]
    for writer, reader in ((task, other), (other, task)):
        given = set(writer.svars(tuple(name for name in writer.outvar if name not in writer.outconst)))
        needed = set(reader.svars(tuple(name for name in reader.inconst if name not in reader.invar)))
        result += [
            f"`{reader.name}` needs {svar} at initialisation, `{writer.name}` gives it only while it runs"
            for svar in sorted(given & needed)
        ]
    return result


aliases = st.lists(st.tuples(st.sampled_from(VARS), st.sampled_from((*VARS, "D"))), max_size=2).map(tuple)
aliased = st.builds(replace, tasks, aliases=aliases)


@given(st.lists(aliased, max_size=6), st.lists(aliased, max_size=6))
@settings(max_examples=examples(200), deadline=None)
def test_reasons_are_those_of_every_pair_in_their_order(library: list[Task], placed: list[Task]) -> None:
    by_name = list({t.name: t for t in library}.values())  # R-C07
    expected = {t.name: [reason for s in placed for reason in plain_reasons(t, s)] for t in by_name}
    result = greyed(by_name, placed)
    assert {name: [str(item.reason) for item in result.get(name, ())] for name in expected} == expected
    assert all([str(refusal.reason) for refusal in refusals(t, placed)] == expected[t.name] for t in by_name)


@given(st.lists(aliased, max_size=6), aliased)
@settings(max_examples=examples(100), deadline=None)
def test_whom_a_task_keeps_out_is_told_as_each_would_be_told(library: list[Task], task: Task) -> None:
    result = [(other.name, refused) for other, refused in PlacedNeighbours(library).kept_out_by(task)]  # R-C07
    assert result == [(other.name, refusals(other, [task])) for other in library if refusals(other, [task])]
