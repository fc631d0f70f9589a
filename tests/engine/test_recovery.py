from kit.engine.play_lines import begins
from kit.plans import build
from onika.engine.news import Cleared, Failed, Finished, Run, Spawned, TurnedOn
from onika.engine.orders import Clear, Off
from onika.wire.steer import Recover
from onika.words.reason import Reason

REACH = build.job("move", "puma", trigger="move", arguments="1 2")


def running(stands_still):
    engine = build.engine([REACH, REACH], stands_still=stands_still)
    for news in (Run(), *(kind(0, task) for kind in (Spawned, TurnedOn) for task in ("move", "puma"))):
        engine.feed(news)
    return engine


def test_where_nobody_is_there_to_decide_an_error_ends_the_application():  # R-E08
    assert [type(order).__name__ for order in running(False).feed(Failed(0, "puma", Reason.plain("x")))] == [
        "Kill",
        "Kill",
    ]


def test_where_somebody_is_the_trigger_goes_off_before_anything_is_told():  # R-E08
    first, second = running(True).feed(Failed(0, "puma", Reason.plain("x")))
    assert first == Off(0, "move")
    assert second.state == "stopped"


def test_all_tasks_in_error_are_cleared_and_nothing_comes_on_before_the_last_is():  # R-E08
    engine = running(True)
    for task in ("puma", "move"):
        engine.feed(Failed(0, task, Reason.plain("x")))
    assert engine.feed(Recover("0"))[1:] == [Clear(0, "move"), Clear(0, "puma")]
    assert engine.feed(Cleared(0, "puma")) == []
    assert [type(order).__name__ for order in engine.feed(Cleared(0, "move"))] == ["Switch", "Began", "Moved"]


def test_a_recovered_action_ends_by_its_trigger_and_not_by_a_word_from_before():  # R-E08
    engine = running(True)
    for news in (Failed(0, "puma", Reason.plain("x")), Recover("0"), Cleared(0, "puma")):
        engine.feed(news)
    assert engine.feed(Finished(0, "move"))[0].text.key == "engine.ends_no_action"
    engine.feed(TurnedOn(0, "move"))
    assert engine.feed(Finished(0, "move"))[-1] == begins(0, 1)[-1]
