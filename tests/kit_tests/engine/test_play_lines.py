from kit.engine.play_lines import JOB, NOOP, begins, ends, goes_on, opened, passes, started
from kit.plans import build
from kit.plans.flow_program import bottom, program
from onika.engine.news import Failed, Finished, TurnedOn
from onika.engine.orders import Began, Done, Launch, Moved, Switch, Together
from onika.wire.plan import Do
from onika.words.reason import Reason

MOVE = Launch("move", "", 100.0)


def test_a_run_that_has_begun_is_in_its_first_action():
    assert started([JOB, JOB]).position(0).state == "running"


def test_a_run_may_begin_with_other_orders():
    play = started([NOOP, JOB], [JOB], first=[*passes(0, 0), Together("", (0, 1)), *begins(0, 1), *begins(1, 0)])
    assert [play.position(flow).action for flow in (0, 1)] == [1, 0]


def test_an_opened_run_lacks_one_task():
    assert [opened([JOB], [JOB]).position(flow).state for flow in (0, 1)] == ["spawning", "spawning"]


def test_a_scene_stands_still_at_an_error_and_judges_as_it_is_told():
    flow = build.flow([JOB, JOB], program(bottom("round", Do(0), condition="X"), Do(1)))
    play = started(flow, judge=lambda number, condition: (number, condition) == (0, "X"))
    play = play >> ends(0) << Done(0, 0) << begins(0, 0)
    text = "test.appl flow 0 action 0: move is in error: x"
    assert play >> Failed(0, "move", Reason.plain("x")) << Moved(0, "stopped", 0, text=Reason.plain(text))


def test_the_lines_are_what_they_say():
    assert begins(1, 2, off=["puma"], number=3) == [Switch(1, ("puma",), (MOVE,), number=3), Began(1, 2)]
    assert goes_on(1, 2) == [Switch(1, (), (MOVE,)), Began(1, 2), Moved(1, "running", 2)]
    assert passes(1, 2) == [Began(1, 2), Done(1, 2)]
    assert ends(1, 2, loop=True, switched=3) == [TurnedOn(1, "move"), Finished(1, "move", 2, True, 3)]
