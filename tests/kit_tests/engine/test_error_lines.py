from kit.engine.error_lines import AGAIN, REACH, clearing, finish, on, paused, running, started, stopped, where
from onika.engine.news import Cleared, Failed, Finished, TurnedOn
from onika.engine.orders import Began, Clear, Launch, Moved, Off, RunNote, Switch
from onika.wire.steer import Recover
from onika.words.reason import Reason


def test_a_mishap_begins_in_the_first_action_of_every_flow_with_all_tasks_on():
    play = started([REACH], [REACH, AGAIN])
    assert [play.position(flow).state for flow in (0, 1)] == ["running", "running"]
    moved = Moved(1, "stopped", 0, text=Reason.plain(f"{where(1, 0)}: puma is in error: joint limit"))
    assert play >> Failed(1, "puma", Reason.plain("joint limit")) << Off(1, "move") << moved


def test_passive_tasks_and_further_triggers_are_as_they_are_given():
    play = started([REACH], passive=[(0, "puma")], others=[(0, "puma")])
    assert play.cases(0) == []
    failed = started([REACH], passive=[(0, "puma")])
    failed = failed >> Finished(0, "ghost") << RunNote(0, Reason.plain("ghost is no task of this flow: ignored"))
    sentence = f"{where(0, 0)}: puma is in error and stays off, the job goes on: x"
    assert failed >> Failed(0, "puma", Reason.plain("x")) << RunNote(0, Reason.plain(sentence))


def test_the_lines_are_what_they_say():
    assert on("move", "puma", arguments="5") == (Launch("move", "5", 100.0), Launch("puma", "", 100.0))
    mishap = stopped(1, "pd", "x", flow=2)
    assert (mishap.flow, mishap.state, mishap.index) == (2, "stopped", 1)
    assert str(mishap.text) == "test.appl flow 2 action 1: pd is in error: x"
    assert (clearing(1, 2), paused(1, 2)) == (Moved(2, "clearing", 1), Moved(2, "paused", 1))
    assert running(1, 2) == [Began(2, 1), Moved(2, "running", 1)]
    assert finish(2) == [TurnedOn(2, "move"), Finished(2, "move")]


def test_a_mishap_can_be_cleared():
    play = started() >> Failed(0, "puma", Reason.plain("joint limit")) << Off(0, "move") << stopped()
    play = play >> Recover("0") << clearing() << Clear(0, "puma")
    assert play >> Cleared(0, "puma") << Switch(0, (), on("move", "puma")) << running(0)
