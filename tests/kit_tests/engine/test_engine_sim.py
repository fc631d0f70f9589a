"""The theatre sees what an engine must not do."""

import pytest

from kit.engine.engine_sim import EngineSim
from kit.plans.program_tree import Act, engine_for, planned
from onika.engine import news
from onika.engine.engine import Engine
from onika.engine.orders import Began, Case, Done, Launch, Off, RunNote, Switch
from onika.wire import steer
from onika.words.reason import Reason

MOVE = (0, "move")


@pytest.fixture
def theatre():
    """Two actions, of which the first runs and all is heard."""
    plan = planned((Act(), Act()))
    made = EngineSim(plan, engine_for(plan, stands_still=True))
    made.feed(news.Run())
    hear_all(made)
    return made


def hear_all(theatre):
    while theatre.speakers():
        theatre.hear(theatre.speakers()[0])


def test_a_run_goes_through_its_actions_to_its_end(theatre):
    for _ in range(2):
        (trigger,) = theatre.triggers_on()
        theatre.say(trigger, news.Finished(*trigger), "off")
        hear_all(theatre)
    assert theatre.end.completed
    assert not theatre.on()


def test_what_was_taken_can_be_put_back(theatre):
    taken, key, story = theatre.take(), theatre.key(), theatre.story
    theatre.feed(news.Abort(Reason.plain("stop")))
    hear_all(theatre)
    assert theatre.end
    theatre.put_back(taken)
    assert (theatre.key(), theatre.story, theatre.end) == (key, story, None)


@pytest.mark.parametrize(
    ("orders", "wrong"),
    [
        ([RunNote(0, Reason.plain("lost"))], "are ON in flow 0, expected"),
        ([Began(0, 1)], "but 0 is open"),
        ([Done(0, 1)], "but 0 is open"),
        ([Done(0, 0), Switch(0, (), (Launch("arm"),)), Began(0, 1)], "is turned on and is on"),
        ([Done(0, 0), Off(0, "move")], "is turned off and is off"),
        ([Done(0, 0), Switch(0, (), ()), Began(0, 1)], "not told to come on anew"),
    ],
)
def test_what_an_engine_must_not_do_is_told_with_the_story(theatre, monkeypatch, orders, wrong):
    theatre.say(MOVE, news.Finished(*MOVE), "off")
    monkeypatch.setattr(Engine, "feed", lambda self, message: orders)
    with pytest.raises(AssertionError, match=wrong) as failure:
        theatre.hear(MOVE)
    assert ">> Run()" in str(failure.value)


def test_a_prepared_switch_that_was_done_has_to_be_ordered(theatre):
    case = theatre.engine.cases(0)[0]
    theatre.finish_ready(case, 0, 0, False)
    assert theatre.is_ready(0)
    theatre.hear(MOVE)
    assert (theatre.is_ready(0), theatre.open) == (False, [1])


def test_another_switch_than_the_prepared_one_is_told(theatre):
    wrong = Case("move", None, None, Switch(0, (), (Launch("move", "", 50.0),)))
    theatre.finish_ready(wrong, 0, 0, False)
    with pytest.raises(AssertionError, match="was carried out"):
        theatre.hear(MOVE)


def test_words_of_an_earlier_activation_are_not_heard():
    plan = planned((Act(), Act()))
    theatre = EngineSim(plan, engine_for(plan, stands_still=True))
    theatre.feed(news.Run())
    for task in ("move", "arm"):
        theatre.hear((0, task))
    theatre.say(MOVE, news.Finished(*MOVE), "off")
    theatre.feed(steer.Skip("flow0", 1))
    assert [type(message) for message in theatre.tasks[MOVE].mail] == [news.TurnedOn]
