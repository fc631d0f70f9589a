import pytest
from tests.model.rules.upper import SYNTAX, application, branch, flow, job, nop, outline, part, texts

from onika.model.application import AppFlow, Application, Icon, Step
from onika.model.rules.endless import faults
from onika.model.rules.nesting import nest

START = {"while_tag": "a"}
TEST = {"while_tag": "a", "while_test": True}
INNER = {"while_tag": "b"}
INNER_TEST = {"while_tag": "b", "while_test": True}


def sentences(*steps: Step, **applications: Application) -> list[str]:
    return texts(faults(nest(outline(flow(*steps)), SYNTAX, applications, {}), SYNTAX))


def test_a_loop_of_no_ops_is_endless_and_one_with_a_job_is_not() -> None:
    assert sentences(job(), nop(line=3, **START), nop(**TEST), job()) == [  # R-D11, R-E05
        (
            "work.appl:3: expected a job on every way round the loop a"
            ", found none on some way from `nop`, step 1 of flow 0, to `nop`, step 2 of flow 0"
        )
    ]
    assert sentences(nop(**START), job(), nop(**TEST)) == []
    assert sentences(nop(**START), job(**TEST)) == []
    assert len(sentences(nop(**START), nop(while_if="LAMP == 1", **TEST))) == 1
    assert len(sentences(nop(synch_tag="meet", **START), nop(**TEST))) == 1


def test_a_branch_takes_time_if_all_its_flows_do() -> None:
    both, item = branch(flow(job()), flow(nop(), job())), branch(flow(job()), flow())  # R-D13
    assert sentences(nop(**START), both, nop(**TEST)) == []
    assert len(sentences(nop(**START), item, nop(**TEST))) == 1
    assert len(sentences(nop(**START), branch(flow(both), flow(item)), nop(**TEST))) == 1


@pytest.mark.parametrize(
    ("test", "faults_"),
    [
        (nop(**INNER_TEST), 0),  # it says TRUE, so that the job follows
        (nop(while_if="LAMP == 1", **INNER_TEST), 1),
        (job(**INNER_TEST), 0),
    ],
)
def test_what_an_inner_top_test_loop_may_pass_by_does_not_count(test: Icon, faults_: int) -> None:
    assert len(sentences(nop(**START), test, job(), nop(**INNER), nop(**TEST))) == faults_  # reading 23, R-E05


def test_an_inner_bottom_test_loop_is_run_once_at_least() -> None:
    assert sentences(nop(**START), nop(**INNER), job(), nop(**INNER_TEST), nop(**TEST)) == []


def test_inner_and_outer_loops_without_a_job_are_both_named() -> None:
    result = sentences(nop(**START), nop(**INNER), nop(**INNER_TEST), nop(**TEST))
    assert [text.split()[10].rstrip(",") for text in result] == ["a", "b"]


def nested(*flows: AppFlow, is_parallel: bool = False) -> dict[str, Application]:
    return {"part": application(*flows, name="part", is_parallel=is_parallel)}


def test_a_nested_application_takes_time_as_its_flows_do() -> None:
    loop = (nop(**START), part(), nop(**TEST))
    assert sentences(*loop, **nested(flow(job()), flow(job()))) == []
    assert len(sentences(*loop, **nested(flow(job()), flow(nop())))) == 1
    assert sentences(*loop, **nested(flow(job()), flow(nop()), is_parallel=True)) == []
    assert sentences(*loop) == []  # that it is missing is told elsewhere


def test_loops_within_nested_applications_and_branches_are_looked_at_too() -> None:
    inner = flow(branch(flow(nop(**START), nop(**TEST)), flow()))
    (text,) = sentences(part(), **nested(inner))
    assert text.startswith("part.appl: ")
    assert "`nop`, step 0 of flow 0, step 0, branch 0 of `part`" in text


def test_loops_that_are_not_well_formed_are_told_elsewhere() -> None:
    assert sentences(nop(**START), nop(**START)) == []
