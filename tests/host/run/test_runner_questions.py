"""A runner answers what tasks ask from what was given beforehand, or asks whoever is there."""

from kit.plans.plan_builder import action
from kit.runtime.runner_rig import RunnerRig
from onika.runtime import command, news
from onika.runtime.user_input import AskedItem
from onika.wire import event
from onika.wire.request import Begin
from onika.words.reason import NOTHING, Reason

ITEM = AskedItem("level", "double", 1, "m", "how high", None, (0.0,), (1.0,))


def asking(begin):
    rig = RunnerRig([action("bell")], begin=begin).start().spawned("bell")
    return rig.hear(news.Asked("flow0", "bell", NOTHING, (ITEM,), rig.now))


def answers(rig):
    return [(order.task, order.line) for _, order in rig.units.take(command.Answer)]


def test_a_given_answer_is_used_once():  # law 25
    rig = asking(Begin(answers=(("bell", "level", "0.5"),)))
    assert answers(rig) == [("bell", "0.5")]
    rig.hear(news.Asked("flow0", "bell", Reason.plain("too low"), (ITEM,), rig.now))
    assert answers(rig) == []
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    assert str(rig.runner.statistics.cause).endswith(
        "task bell asks for bell.level (too low) and nobody is there to answer"
    )


def test_an_answer_under_a_name_that_is_not_asked_for_ends_the_run():  # law 25
    rig = asking(Begin(answers=(("bell", "lvl", "0.5"),)))
    assert answers(rig) == []
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    assert "task bell asks for level, and an answer is given for lvl" in str(rig.runner.statistics.cause)


def test_whoever_is_there_is_asked_and_answers():  # law 25, R-E15
    rig = asking(Begin(may_ask=True))
    (question,) = rig.of(event.Asked)
    assert (question.subsystem, question.task, question.items[0].name, question.items[0].high) == (
        "flow0",
        "bell",
        "level",
        (1.0,),
    )
    assert rig.runner.is_asking
    assert rig.runner.questions("flow0") == (question,)  # for whoever comes later
    assert rig.runner.questions("flow1") == ()
    rig.runner.answer("flow0", "bell", "0.5")
    assert answers(rig) == [("bell", "0.5")]
    rig.turned_on("bell")
    assert rig.runner.questions("flow0") == ()
    assert not rig.runner.is_asking


def test_an_answer_to_nobody_goes_nowhere():
    rig = asking(Begin(may_ask=True))
    rig.runner.answer("flow7", "bell", "0.5")
    rig.runner.answer("flow0", "nobody", "0.5")
    assert answers(rig) == []
