"""Prepared switches: what follows a finish at once, and what makes that be forgotten."""

import pytest
from msgspec import structs

from kit.labs.module_source import COUNTER, cycle, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from onika.model.lifecycle import State
from onika.model.signal import Signal, SignalKind
from onika.runtime import command, news
from onika.runtime.prepared_switches import PreparedSwitches, lines
from onika.words.reason import Reason

MS = 1_000_000
GOAL = module("    G = Input('double', 'm', 'goal')\n    def on(self, inputs):\n        self.goal = inputs.G")
ENDS = module(
    "    def cycle(self):\n        return finish(flow=1, loop=True) if self.now >= self.end else None\n    end = 0.02",
    trigger=True,
)


def switch(on=(), off=(), subsystem=HOME):
    launches = tuple(
        launch if isinstance(launch, command.Launch) else command.Launch(launch, "", None, 8) for launch in on
    )
    return command.Switch(subsystem, tuple(off), (), launches)


def case(number, choice=None, loop=None, on=("next",), off=("beside",)):
    return command.Case(choice, loop, number, switch(on, off))


def prepared(*cases, task="end", activation=7):
    return command.PreparedSwitch(HOME, task, activation, cases or (case(1),))


def rig_of(source=ENDS, **given):
    """A trigger that ends at 20 ms and a task beside it are ON; another is OFF."""
    rig = ExecutiveRig(**given).spawn("end", source)
    for name in ("beside", "next"):
        rig.spawn(name, COUNTER, aliases={"N": f"N_{name.upper()}"}, rank=1)
    return rig.switch(on=[command.Launch("end", "", None, 7), "beside"])


def states(rig):
    return [rig.task(name).state.value for name in ("end", "beside", "next")]


# At the finish


def test_a_prepared_switch_is_carried_out_with_the_finish_itself():  # law 6
    rig = rig_of().do(prepared()).run(20 * MS)
    at_finish = [event for at, event in rig.news if at == 20 * MS]
    assert at_finish == [
        news.Finished(HOME, "end", 1, True, 20 * MS, 7, switched=1),
        news.Changed(HOME, "beside", "OFF", 20 * MS),
        news.Changed(HOME, "next", "ON", 20 * MS, activation=8),
        news.Cycled(HOME, "next", 20 * MS, 8),
    ]
    assert states(rig) == ["OFF", "OFF", "ON"]


def test_all_that_a_finish_led_to_is_told_in_one_go():
    rig = rig_of().do(prepared())
    rig.run(20 * MS - 1)
    rig.now = 20 * MS
    goes = iter(lambda: rig.executive.run_next(rig.now), None)
    together = next(list(events) for events in goes if any(isinstance(event, news.Finished) for event in events))
    assert [type(event) for event in together] == [news.Finished, news.Changed, news.Changed]


def test_the_story_is_that_of_a_runner_who_answers_in_no_time():  # law 1
    def react(event):
        return [switch(["next"], ["beside"])] if isinstance(event, news.Finished) else []

    outcomes = [
        [
            (at, structs.replace(event, switched=0) if isinstance(event, news.Finished) else event)
            for at, event in rig.news
        ]
        for rig in (rig_of().do(prepared()).run(50 * MS), rig_of(react=react).run(50 * MS))
    ]
    assert outcomes[0] == outcomes[1]


@pytest.mark.parametrize(
    ("cases", "number"),
    [
        ((case(3, 1, True),), 3),
        ((case(3, 0, True), case(4, 1, None)), 4),
        ((case(3, None, False), case(4, None, True)), 4),
        ((case(3, None, True), case(4, 1, True)), 3),
        ((case(3, 0, None), case(4, None, False)), 0),
    ],
)
def test_the_first_case_that_fits_the_value_counts(cases, number):  # R-D10
    rig = rig_of().do(prepared(*cases)).run(50 * MS)
    assert rig.news_of(news.Finished)[0].switched == number
    assert states(rig) == (["OFF", "OFF", "ON"] if number else ["OFF", "ON", "OFF"])


@pytest.mark.parametrize("order", [prepared(activation=6), prepared(task="beside")])
def test_what_was_prepared_for_another_finish_is_not_carried_out(order):
    rig = rig_of().do(order).run(50 * MS)
    assert (rig.news_of(news.Finished)[0].switched, states(rig)) == (0, ["OFF", "ON", "OFF"])


def test_the_same_trigger_may_come_on_again_by_it():
    rig = rig_of(ENDS.replace("end = 0.02", "end = 0.0"))
    rig.do(prepared(case(1, on=[command.Launch("end", "", None, 8)], off=()))).run(10 * MS)
    assert [(event.activation, event.switched) for event in rig.news_of(news.Finished)] == [(7, 1), (8, 0)]


def test_a_task_that_comes_on_by_it_gets_its_input_or_asks():  # R-A10
    for line, state in (("2.5", State.ON), ("much", State.ASKING)):
        rig = rig_of().spawn("goes", GOAL)
        rig.do(prepared(case(1, on=[command.Launch("goes", line, None, 9)]))).run(20 * MS)
        assert rig.task("goes").state is state
    assert rig.news_of(news.Asked)[0].activation == 9


def test_what_it_names_and_is_still_to_come_comes_on_when_it_is_there():  # law 21
    rig = rig_of()
    rig.do(rig.spawn_of("late", COUNTER, aliases={"N": "N_LATE"}, cost_ns=1_000))
    assert rig.executive.has_work
    rig.do(prepared(case(1, on=("late",)))).run(20 * MS)
    assert states(rig)[:2] == ["OFF", "OFF"]
    while rig.executive.has_work:
        rig.executive.work(rig.now)
    assert rig.task("late").is_on


# Forgotten


@pytest.mark.parametrize(
    "order",
    [
        command.PreparedSwitch(HOME, "end", 7, ()),
        switch(),
        command.Together((switch(),)),
        command.Kill(HOME, "next"),
        command.Kill(HOME, "other"),
        command.Fail(Reason.plain("the server is gone")),
    ],
    ids=lambda message: f"{type(message).__name__} {getattr(message, 'task', '')}",
)
def test_what_was_prepared_is_forgotten_with(order):  # law 6
    rig = rig_of().do(prepared()).do(order).run(50 * MS)
    assert rig.news_of(news.Finished)[0].switched == 0


@pytest.mark.parametrize(
    "order", [switch(subsystem="other"), command.Kill("other", "next"), command.Report(), prepared(case(1))]
)
def test_what_was_prepared_stays_with(order):
    rig = rig_of().do(prepared()).do(order).run(50 * MS)
    assert rig.news_of(news.Finished)[0].switched == 1


def test_after_a_stop_and_a_reset_nothing_comes_on_by_what_was_prepared():  # law 27
    rig = rig_of().do(prepared()).do(command.Stop()).do(command.Reset()).run(50 * MS)
    rig.switch(on=[command.Launch("end", "", None, 7)]).run(90 * MS)
    assert rig.news_of(news.Finished)[0].switched == 0
    assert rig.task("next").state is State.OFF


@pytest.mark.parametrize("name", ["beside", "other"])
def test_a_task_that_fails_takes_with_it_what_was_prepared(name):  # R-E08
    rig = rig_of().spawn("other", COUNTER, aliases={"N": "N_OTHER"}).switch(on=["other"]).do(prepared())
    rig.task(name).module.cycle = lambda: 1 / 0
    rig.run(50 * MS)
    assert rig.news_of(news.Failed)[0].task == name
    assert rig.news_of(news.Finished)[0].switched == 0


def test_a_task_that_switches_itself_off_takes_with_it_what_was_prepared():  # R-A08
    rig = rig_of().spawn("quiet", cycle("return off()", passive=True)).switch(on=["quiet"]).do(prepared())
    rig.run(50 * MS)
    assert rig.news_of(news.Finished)[0].switched == 0


def test_that_nothing_is_prepared_any_more_is_told_behind_what_was_carried_out():
    rig = rig_of().do(prepared()).run(20 * MS).do(command.PreparedSwitch(HOME, "end", 7, ()))
    assert rig.news_of(news.Finished)[0].switched == 1
    assert rig.news[-1][1] == news.Unprepared(HOME)


def test_a_trigger_that_fails_on_its_way_out_leads_to_nothing():  # R-A09
    body = "    def cycle(self):\n        return finish()\n    def off(self):\n        1 / 0"
    rig = rig_of(module(body, trigger=True)).do(prepared(task="end")).run(20 * MS)
    assert rig.news_of(news.Finished) == []
    assert states(rig) == ["ERROR", "ON", "OFF"]


# The store itself


def test_one_is_held_for_each_subsystem_and_given_once():
    held, finish = PreparedSwitches(), Signal(SignalKind.FINISH)
    held.keep(prepared(case(1)))
    held.keep(prepared(case(2)))
    held.keep(structs.replace(prepared(case(3)), subsystem="other"))
    assert len(held) == 2
    taken = [held.take(name, "end", 7, finish) for name in (HOME, HOME, "other")]
    assert [switch and switch.number for switch in taken] == [2, None, 3]


def test_lines_of_all_cases_are_told_by_task():
    first, other = case(1, on=[command.Launch("a", "1")]), case(2, on=[command.Launch("a", "2"), command.Launch("b")])
    assert lines((first, other)) == {"a": ["1", "2"], "b": [""]}


def test_a_cycle_of_its_own_is_what_a_prepared_task_begins_with():  # law 6: no cycle of the old job in between
    rig = rig_of(cycle("return finish()", trigger=True)).do(prepared()).run(0)
    assert rig["N_NEXT"] == 1
    assert rig["N_BESIDE"] == 0
