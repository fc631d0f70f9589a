from onika.desk.plan.lone_job import lone_job
from onika.store.site import open_site
from onika.words.fault import Fault


def test_a_job_is_planned_with_all_its_tasks_and_their_rates_there():
    job = lone_job("jmoveC", open_site([], {}, None))
    assert not isinstance(job, Fault) and job.plan is not None
    (flow,) = job.plan.flows
    assert "jtraj" in {task.name for task in flow.tasks}
    assert dict(flow.actions[0].rates)["puma"] == 500.0


def test_a_name_that_is_none_of_a_configuration_is_a_fault():
    job = lone_job("nosuch", open_site([], {}, None))
    assert isinstance(job, Fault) and job.sentence.key
