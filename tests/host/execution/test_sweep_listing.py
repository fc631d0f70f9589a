import ast

import pytest

from onika.desk.plan.lone_job import lone_job
from onika.host.execution.sweep_listing import sweep_listing
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.store.site import open_site


@pytest.fixture(scope="module")
def job():
    planned = lone_job("jmoveC", open_site([], {}, None))
    preparation = prepare(planned.plan, planned.targets, ModuleFacts())
    return preparation.flows[0], dict(planned.plan.flows[0].actions[0].rates), preparation.constants[0]


def test_each_rate_has_a_sweep_of_its_own_fastest_first(job):  # law 1
    listing = sweep_listing("flow0", *job)
    assert [rate for rate, _ in listing] == [500.0, 250.0, 50.0]
    assert all(ast.parse(text) for _, text in listing)


def test_hardware_is_the_source_and_what_it_publishes_goes_on_in_the_same_sweep(job):  # law 1
    fast = sweep_listing("flow0", *job)[0][1]
    assert fast.index("puma_guard.take_in(now)") < fast.index("diff_Q_MEZ[ALL] = puma_Q_MEZ") < fast.index("pd.cycle()")


def test_a_task_without_a_rate_is_in_no_sweep(job):
    wired, rates, constants = job
    others = [task for task in wired if task.name != "puma"]
    listing = sweep_listing("flow0", others, {**rates, "jtraj": 500.0}, constants)
    assert "puma.cycle" not in "".join(text for _, text in listing)
    assert "jtraj.cycle()" in listing[0][1]
