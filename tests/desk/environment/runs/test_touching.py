import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.wire import act, live, request
from onika.words.reason import Reason


@pytest.fixture
def play(tmp_path):
    """A run in whose world `cell` there is a panic button."""
    play = RunFixture(tmp_path)
    play.files.plain_task("a", writes="A", local="DEVICE cell:arm\n")
    play.runtime.worlds = {"cell": True}
    play.rebuffs[live.Touch] = request.Done()
    play.run(play.open([job("aC")]))
    return play


def pressed(play):
    return play.environment.tree.runtime.pressed


def test_a_part_is_pressed_and_let_go_while_a_run_goes_on_and_every_page_shows_it(play):  # R-K06, R-F10
    play.do(act.Touch("cell", "panic", True))
    assert pressed(play) == {"cell": ("panic",)}
    play.do(act.Touch("cell", "panic", False))
    assert pressed(play) == {}
    assert play.carried(live.Touch) == [live.Touch("cell", "panic", 1.0), live.Touch("cell", "panic", 0.0)]


def test_a_part_that_the_runtime_refuses_is_not_shown_pressed(play):  # R-K06
    play.rebuffs[live.Touch] = request.Refused(Reason.plain("no such part"))
    assert play.answer(act.Touch("cell", "lever", True)).no.reason == Reason.plain("no such part")
    assert pressed(play) == {}


def test_a_world_that_is_not_open_has_nothing_to_touch(play):  # R-K06
    assert play.answer(act.Touch("shed", "panic", True)).no.reason.key == "run.touch_not_open"
    assert play.carried(live.Touch) == []


def test_a_real_world_is_not_touched_from_a_page(tmp_path):  # R-K06, R-E09
    play = RunFixture(tmp_path)
    play.files.plain_task("a", writes="A", local="DEVICE cell:arm\n")
    play.runtime.worlds = {"cell": False}
    play.run(play.open([job("aC")]))
    assert play.answer(act.Touch("cell", "panic", True)).no.reason.key == "run.touch_real"
    assert play.carried(live.Touch) == []
