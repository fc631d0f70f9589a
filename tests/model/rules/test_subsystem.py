from collections.abc import Mapping

from tests.model.rules.upper import SYNTAX, application, branch, conf, flow, job, outline, part, texts

from onika.model.application import AppFlow, Application
from onika.model.rules.nesting import nest
from onika.model.rules.subsystem import SharedSubsystem, faults, subsystems
from onika.model.task import Task


def result(*flows: AppFlow, applications: Mapping[str, Application] | None = None) -> dict[str, SharedSubsystem]:
    return subsystems(nest(outline(*flows, is_parallel=True), SYNTAX, applications or {}, {}), SYNTAX)


def jobs(subsystem_of: dict[str, SharedSubsystem]) -> dict[str, list[str]]:
    return {name: list(item.uses) for name, item in subsystem_of.items()}


def test_every_flow_has_a_subsystem_with_what_is_nested_in_it_in_line() -> None:
    inner = application(flow(job("c"), job("a")), flow(job("d")), name="part")  # R-E01, R-D10
    steps = flow(job("a"), branch(flow(job("b")), flow()), part())
    assert jobs(result(steps, flow(job("a")), applications={"part": inner})) == {
        "flow0": ["a", "b", "c", "d"],
        "flow1": ["a"],
    }


def test_further_flows_of_a_nested_parallel_application_have_subsystems_of_their_own() -> None:
    deep = application(flow(job("x")), flow(job("y")), name="deep", is_parallel=True)  # R-D13
    pair = application(flow(job("a")), flow(job("b"), part("deep")), name="pair", is_parallel=True)
    both = {"deep": deep, "pair": pair}
    assert jobs(result(flow(part("pair"), part("deep")), applications=both)) == {
        "flow0": ["a", "x"],
        "flow0.1": ["b", "x", "y"],
        "flow0.1.1": ["y"],
    }


def test_tasks_conflict_within_a_subsystem_only() -> None:
    configurations = {"a": conf("a", "one"), "b": conf("b", "two")}  # reading 1
    tasks = {name: Task(name, "m") for name in ("one", "two")}

    def sentences(*flows: AppFlow, inner: Application) -> list[str]:
        return texts(faults(result(*flows, applications={"part": inner}), configurations, tasks))

    apart = application(flow(job("b")), name="part")
    assert sentences(flow(job("a")), flow(job("b")), inner=apart) == []
    assert sentences(flow(job("a"), part()), inner=apart) == [
        (
            "part.appl: expected every module once in a flow"
            ", found m in `one` (in `a`, step 0) and `two` (in `b`, step 0 of flow 0 of `part`) of flow 0"
        )
    ]
    beside = application(flow(job("a")), flow(job("b")), name="part", is_parallel=True)
    assert sentences(flow(part()), inner=beside) == []


TASKS = {"t": Task("t", "t", invar=("X",), aliases=(("X", "LAMP"),)), "u": Task("u", "u", outvar=("Y",))}
CONFIGURATIONS = {"a": conf("a", "t"), "b": conf("b", "u")}


def conditions(text: str, configurations: Mapping[str, object] = CONFIGURATIONS) -> list[str]:
    marked = flow(job("a", marker=True, marker_if=text, line=5))
    return texts(faults(result(marked, flow(job("b"))), configurations, TASKS))  # type: ignore[arg-type]


def test_a_condition_speaks_of_a_variable_that_a_task_of_its_flow_has() -> None:
    assert conditions("LAMP == 1") == []  # R-D13, R-E13
    assert conditions("flow1/Y[2] > 1") == []
    at = "at `a`, step 0 of flow 0"
    assert conditions("Y == 1") == [
        f"work.appl:5: expected a condition on a variable that a task of flow0 has, found `Y == 1` {at}"
    ]
    assert conditions("X == 1") == [
        f"work.appl:5: expected a condition on a variable that a task of flow0 has, found `X == 1` {at}"
    ]
    assert conditions("flow2/Y == 1") == [
        f"work.appl:5: expected a condition on a variable of flow0, flow1, found `flow2/Y == 1` {at}"
    ]
    assert conditions("LAMP") == [
        f"work.appl:5: expected an address, a comparison and a number, as in 'LAMP == 1', found `LAMP` {at}"
    ]


def test_where_tasks_are_missing_no_variable_is_missed() -> None:
    assert conditions("Y == 1", {"a": conf("a", "t", "lost"), "b": CONFIGURATIONS["b"]}) == []
    assert conditions("Y == 1", {"b": CONFIGURATIONS["b"]}) == []


def test_conditions_of_branches_and_loops_are_looked_at_wherever_they_stand() -> None:
    choice = branch(flow(job("a", while_tag="l", while_test=True, while_if="NO == 1")), flow(), conditions=("NO == 2",))
    inner = application(flow(job("a"), choice), name="part")
    sentences = texts(faults(result(flow(part()), applications={"part": inner}), CONFIGURATIONS, TASKS))
    assert [text.partition(", found ")[2] for text in sentences] == [
        "`NO == 2` at a branch of 2, step 1 of flow 0 of `part`",
        "`NO == 1` at `a`, step 0 of flow 0, step 1, branch 0 of `part`",
    ]
