"""What holds for every plan, whatever the tasks do and in whatever order their news arrive."""

from collections import Counter

from hypothesis import given, settings, strategies as st

from kit.engine.fake_runtime import FakeRuntime, Fault
from kit.examples import examples
from kit.plans import build
from onika.engine.orders import Began, Done, End, Kill, Settle, Spawn

TRIGGERS = ("move", "grip", "pause")
GENERAL = ("puma", "pd", "filter")
PASSIVE = ("view", "log")
HARMLESS = (None, None, Fault.ASK, Fault.FINISH_TWICE)
HARMLESS_OF_PASSIVE = (None, Fault.ASK, Fault.SWITCH_OFF, Fault.FAIL, Fault.REFUSE)

jobs = st.builds(
    lambda trigger, others, arguments, rates: build.job(
        *others[:1],
        trigger,
        *others[1:],
        trigger=trigger,
        arguments=arguments,
        rates={name: rate for name, rate in rates.items() if name in (trigger, *others)},
    ),
    trigger=st.sampled_from(TRIGGERS),
    others=st.lists(st.sampled_from(GENERAL + PASSIVE), unique=True),
    arguments=st.sampled_from(["", "1 2", "3 4"]),
    rates=st.dictionaries(st.sampled_from(GENERAL + TRIGGERS), st.sampled_from([50.0, 200.0]), max_size=2),
)
flows = st.lists(st.lists(jobs, min_size=1, max_size=6), min_size=1, max_size=3)


class Chance:
    """Choices drawn one by one, so that a failing story is made as short as can be."""

    def __init__(self, data, faults=HARMLESS, faults_of_passive=HARMLESS_OF_PASSIVE):
        self._data = data
        self._faults = {**dict.fromkeys(TRIGGERS, faults), **dict.fromkeys(PASSIVE, faults_of_passive)}

    def choose(self, choices):
        return self._data.draw(st.integers(0, choices - 1))

    def fault(self, address):
        return self._data.draw(st.sampled_from(self._faults.get(address[1], (None,))))


def runtime(plan, chance):
    numbers = range(len(plan))
    engine = build.engine(*plan, passive={(flow, name) for flow in numbers for name in PASSIVE})
    triggers = frozenset((flow, name) for flow in numbers for name in TRIGGERS)
    return FakeRuntime(engine, triggers, chance.choose, chance.fault)


def given_orders(run, kind):
    return [order for order in run.orders if isinstance(order, kind)]


def all_lives_are_ended(run, plan):
    """Every spawned task is killed once, and the end is said once and last."""
    spawned = Counter((order.flow, order.task) for order in given_orders(run, Spawn))
    assert spawned == Counter((flow, name) for flow, jobs in enumerate(plan) for name in build.names(jobs))
    assert Counter((order.flow, order.task) for order in given_orders(run, Kill)) == spawned
    assert len(given_orders(run, End)) == 1
    assert isinstance(run.orders[-1], End)


def actions_begin_in_their_order(run, plan):
    """No action is begun twice, none is skipped, and each but the last one begun is done before the next."""
    for flow in range(len(plan)):
        marks = [order for order in given_orders(run, Began | Done) if order.flow == flow]
        indices = [(type(order), order.index) for order in marks]
        assert indices == [(kind, index) for index in range(len(plan[flow])) for kind in (Began, Done)][: len(indices)]


def actions_have_their_tasks(run, plan):
    """ON during an action are exactly its tasks, at its rates, but for passive ones that have fallen silent."""
    for (flow, index), on in run.on_during.items():
        job = plan[flow][index]
        wanted = {name: job.rates.get(name, 100.0) for name in job.tasks}
        assert on.items() <= wanted.items()
        assert wanted.keys() - on.keys() <= set(PASSIVE)


def triggers_are_told_their_targets(run, plan):
    """The trigger of every action is turned ON for it, once, with its argument line; nobody else gets one."""
    for (flow, index), activations in run.activations.items():
        job = plan[flow][index]
        assert [each.arguments for each in activations if each.task == job.trigger] == [job.arguments]
        assert not any(each.arguments for each in activations if each.task != job.trigger)


@settings(max_examples=examples(150), deadline=None)
@given(flows, st.data())
def test_a_run_in_which_nothing_serious_happens_is_completed(plan, data):  # R-E02, R-E03, R-E14
    run = runtime(plan, Chance(data))
    run.run()
    all_lives_are_ended(run, plan)
    actions_begin_in_their_order(run, plan)
    actions_have_their_tasks(run, plan)
    triggers_are_told_their_targets(run, plan)
    assert set(run.on_during) == {(flow, index) for flow, jobs in enumerate(plan) for index in range(len(jobs))}
    assert len(given_orders(run, Settle)) == 1
    assert run.orders[-1] == End(True)


@settings(max_examples=examples(150), deadline=None)
@given(flows, st.data(), st.integers(0, 60))
def test_a_run_ends_once_and_cleanly_wherever_it_is_broken(plan, data, abort_after):  # R-E07, R-E08
    run = runtime(plan, Chance(data, faults=(*HARMLESS, *HARMLESS, Fault.FAIL, Fault.REFUSE, Fault.SWITCH_OFF)))
    run.run(abort_after)
    if not isinstance(run.orders[-1], End):
        run.run(abort_after=0)  # a trigger has switched itself off: the flow waits until the user ends it
    all_lives_are_ended(run, plan)
    actions_begin_in_their_order(run, plan)
    actions_have_their_tasks(run, plan)
    triggers_are_told_their_targets(run, plan)
    end = given_orders(run, End)[0]
    assert bool(end.cause) != end.completed
    assert not end.completed or len(given_orders(run, Done)) == sum(map(len, plan))


@settings(max_examples=examples(100), deadline=None)
@given(st.lists(st.integers(0, 2), min_size=2, max_size=3), st.integers(1, 3), st.data())
def test_flows_that_meet_as_often_as_each_other_always_get_through(before, meetings, data):  # R-E04
    free = build.job("move", trigger="move")
    meet = build.job("move", trigger="move", synch_tag="meet")
    plan = [([free] * count + [meet]) * meetings for count in before]
    run = runtime(plan, Chance(data))
    run.run()
    assert run.orders[-1] == End(True)
    begun = [order for order in given_orders(run, Began) if plan[order.flow][order.index] is meet]
    met = [begun[start : start + len(plan)] for start in range(0, len(begun), len(plan))]
    assert [[order.flow for order in each] for each in met] == [list(range(len(plan)))] * meetings
