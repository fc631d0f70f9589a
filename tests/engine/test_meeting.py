from onika.engine.meeting import Meetings
from onika.engine.progress import Progress
from onika.engine.step import steps
from onika.testing import build

MEET = build.job("b", trigger="b", synch_tag="meet")
FREE = build.job("a", trigger="a")


def begun(*flows):
    """The flows of a plan, all spawned, and their meetings."""
    plan = build.plan(*flows)
    made = []
    for number, (planned, jobs) in enumerate(zip(plan.flows, flows, strict=True)):
        ranks = {name: place for place, name in enumerate(build.names(jobs))}
        ready = steps(planned, {index: job.trigger for index, job in enumerate(jobs)}, set(), ranks)
        made.append(Progress(number, planned, ready, ranks))
        made[-1].spawn()
    return Meetings(plan.flows), made


def test_all_flows_that_contain_a_tag_are_its_parties():  # R-E04, decision 26
    meetings, _ = begun([MEET], [FREE], [FREE, MEET, MEET], [MEET])
    assert list(meetings.parties("meet")) == [0, 2, 3]


def test_a_flow_is_absent_until_it_waits_at_the_tag():  # R-E04
    meetings, flows = begun([MEET], [FREE, MEET])
    assert meetings.absent("meet", flows) == [0, 1]
    flows[0].hold()
    assert meetings.absent("meet", flows) == [1]
    flows[1].begin()
    assert meetings.absent("meet", flows) == [1]
    flows[1].hold()
    assert meetings.absent("meet", flows) == []


def test_a_flow_at_another_tag_is_absent():
    meetings, flows = begun([MEET], [build.job("b", synch_tag="other"), MEET])
    flows[0].hold()
    flows[1].hold()
    assert meetings.absent("meet", flows) == [1]


def test_those_that_wait_for_an_ended_flow_are_deserted():  # decision 26
    meetings, flows = begun([MEET], [MEET], [FREE])
    flows[0].hold()
    assert meetings.deserted(1, flows) == [(flows[0], "meet")]
    assert meetings.deserted(2, flows) == []
