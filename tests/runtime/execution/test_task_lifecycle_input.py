"""User input that is missing or wrong, and the number that each coming on carries."""

import pytest

from kit.labs.module_source import COUNTER, cycle, module
from kit.runtime.executive_rig import HOME, ExecutiveRig, rig_of
from onika.model.lifecycle import State
from onika.runtime import command, news

MS = 1_000_000


# User input

ASKS = module(
    "    QMAX = InConst('double[2]')\n    goal = Input('double[2]', 'rad', 'where', low=0, high='QMAX')\n"
    "    def on(self, inputs):\n        self.goal = inputs.goal\n"
    "        if inputs.goal[0] == 0.5:\n            raise AskAgain('anywhere but there')"
)


def asking_rig():
    rig = ExecutiveRig()
    rig.spawn("limit", module("    QMAX = OutConst('double[2]')\n    def init(self):\n        self.QMAX = 3.0"))
    return rig.spawn("one", ASKS)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("", ""),
        ("1", "expected 2 values"),
        ("1 2 3", "expected 2 values"),
        ("1 x", "goal[1]: expected a number"),
        ("1 3.5", "goal[1]: expected 0..3 rad, found 3.5"),
        ('"1', "double quotes"),
        ("0.5 1", "anywhere but there"),
    ],
)
def test_input_that_is_missing_or_wrong_is_asked_for_with_the_reason_until_it_is_right(line, reason):  # R-A10
    rig = asking_rig().switch(on=[command.Launch("one", line)])
    question = rig.last(news.Asked)
    assert reason in question.reason
    assert bool(question.reason) == bool(reason)
    assert (question.items[0].name, question.items[0].count, question.items[0].high) == ("goal", 2, (3.0, 3.0))
    assert rig.run(50 * MS).task("one").counters.cycles == 0
    rig.do(command.Answer(HOME, "one", "9 9"))
    assert "expected 0..3 rad, found 9" in rig.last(news.Asked).reason
    assert rig.task("one").state is State.ASKING
    rig.do(command.Answer(HOME, "one", "1 2")).run(rig.now)
    assert rig.task("one").state is State.ON
    assert rig.task("one").module.goal.tolist() == [1.0, 2.0]


def test_a_task_that_asks_can_be_turned_off_and_its_off_is_not_run():  # R-A10
    source = ASKS + "\n    def off(self):\n        raise ValueError('never was on')"
    rig = ExecutiveRig().spawn("limit", module("    QMAX = OutConst('double[2]')")).spawn("one", source)
    rig.switch(on=["one"]).switch(off=["one"])
    assert (rig.task("one").state, rig.news_of(news.Failed)) == (State.OFF, [])


# Activations


def test_news_carry_the_activation_of_the_last_launch():  # R-A07
    source = cycle("return finish()", trigger=True)
    rig = rig_of(source).switch(on=[command.Launch("one", activation=7)]).run(0)
    rig.switch(on=[command.Launch("one", activation=8)]).run(rig.now)
    events = [(type(event).__name__, event.activation) for _, event in rig.news[1:]]
    assert events == [(name, run) for run in (7, 8) for name in ("Changed", "Cycled", "Finished")]


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        ("return illegal('x')", news.Signalled),
        ("return off()", news.Changed),
        ("raise ValueError", news.Failed),
        ("pass", news.Cycled),
    ],
)
def test_every_word_of_a_run_carries_its_activation(line, kind):  # R-A07
    rig = rig_of(cycle(line)).switch(on=[command.Launch("one", activation=7)]).run(0)
    assert rig.last(kind).activation == 7


def test_a_question_and_what_follows_its_answer_carry_the_activation():  # R-A10
    rig = asking_rig().switch(on=[command.Launch("one", activation=5)])
    assert rig.last(news.Asked).activation == 5
    assert rig.do(command.Answer(HOME, "one", "1 2")).last(news.Changed).activation == 5
    assert rig.do(command.Kill(HOME, "one")).last(news.Changed).activation == 5


def test_a_launch_that_is_refused_leaves_the_activation_of_the_present_run():
    rig = rig_of(COUNTER).switch(on=[command.Launch("one", activation=1)])
    rig.switch(on=[command.Launch("one", activation=2)]).switch(off=["one"])
    assert rig.last(news.Changed).activation == 1
