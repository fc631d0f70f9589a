import pytest

from kit.plans import build
from onika.engine.orders import Launch
from onika.engine.step import steps


def made(job, *, trigger=None, others=(), ranks=None):
    planned = build.plan([job]).flows[0]
    ranks = ranks or {name: place for place, name in enumerate(job.tasks)}
    return steps(planned, {0: trigger}, set(others), ranks)[0]


def test_the_tasks_of_a_step_stand_in_the_order_of_their_ranks():
    step = made(build.job("move", "pd", "puma"), ranks={"puma": 0, "move": 1, "pd": 2})
    assert step.tasks == ("puma", "move", "pd")


def test_a_rate_of_the_action_overrides_that_of_the_task():  # reading 13
    step = made(build.job("move", "puma", rates={"move": 50.0}))
    assert step.rates == {"move": 50.0, "puma": 100.0}


def test_the_argument_line_goes_to_the_first_trigger_only():  # R-E15
    step = made(build.job("move", "count", "puma", arguments="1 2"), trigger="move", others=["count"])
    assert [step.start(task) for task in step.tasks] == [
        Launch("move", "1 2", 100.0),
        Launch("count", "", 100.0),
        Launch("puma", "", 100.0),
    ]


def test_the_trigger_that_takes_the_target_stands_first():
    assert made(build.job("a", "b", "c"), trigger="c", others=["c", "a", "elsewhere"]).triggers == ("c", "a")


def test_a_job_without_a_trigger_has_none():
    assert made(build.job("a", "b")).triggers == ()


def test_a_trigger_that_is_not_in_the_job_is_refused():
    with pytest.raises(ValueError, match="expected a trigger out of"):
        made(build.job("a"), trigger="b")


def test_a_task_without_a_rank_is_refused():
    with pytest.raises(KeyError):
        made(build.job("a", "b"), ranks={"a": 0})
