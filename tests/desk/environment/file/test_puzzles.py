import pytest

from onika.desk.environment.file.puzzles import SCORES, begin_puzzle, list_puzzles
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.files.puzzles.scores import PuzzleScores
from onika.store.site import open_site
from onika.wire import act

SITE = open_site([], {}, None)
MODEL = Model(syntax=SITE.syntax()[0])


@pytest.fixture
def outside(tmp_path):
    return Services(SITE, lambda: 0.0, tmp_path)


def begun(outside, name, model=MODEL, doc=""):
    done = begin_puzzle(model, act.BeginPuzzle(name, doc), outside)
    assert isinstance(done, Done)
    return done.model, done.model.applications[done.value]


def names(opened):
    return [step.onikon.name for flow in opened.application.flows for step in flow.steps]


def test_puzzles_are_listed_with_how_far_one_is(outside):  # R-G10
    PuzzleScores(outside.state / SCORES).note("climb", 2, 3, 5.4)
    PuzzleScores(outside.state / SCORES).note("climb", 0, 1, 1.0)
    views = {view.name: view for view in list_puzzles(MODEL, act.ListPuzzles(), outside).value.puzzles}
    assert (views["climb"].tries, views["climb"].best.stars, views["climb"].best.actions) == (2, 2, 3)
    assert (views["light_the_lamp"].tries, views["light_the_lamp"].best) == (0, None)
    assert views["waving"].is_fault and not views["climb"].is_fault
    assert set(views["climb"].titles) == {"en", "es"}


def test_without_a_place_to_keep_them_there_are_no_scores():  # R-G10
    views = list_puzzles(MODEL, act.ListPuzzles(), Services(SITE, lambda: 0.0)).value.puzzles
    assert views and all(view.best is None and view.tries == 0 for view in views)


def test_a_puzzle_begins_with_an_empty_program_that_is_judged_by_it(outside):  # R-G10
    _, opened = begun(outside, "climb")
    assert (opened.name, opened.puzzle, names(opened), opened.opened) == ("climb", "climb", [], None)


def test_one_of_mending_begins_with_its_faulty_program(outside):  # R-H07
    _, opened = begun(outside, "empty_hand")
    assert names(opened).count("opengripC") == 2 and "closegripC" not in names(opened)
    assert all(step.number for flow in opened.application.flows for step in flow.steps)


def test_begun_anew_it_is_open_beside_the_former_try(outside):  # R-G10
    model, _ = begun(outside, "climb")
    model, second = begun(outside, "climb", model)
    assert second.name == "climb-2" and len(model.applications) == 2


def test_a_program_that_is_open_may_be_judged_by_a_puzzle(outside):  # R-G10
    model, opened = begun(outside, "climb")
    _, again = begun(outside, "swing_aside", model, opened.id)
    assert (again.id, again.puzzle) == (opened.id, "swing_aside")


def test_what_is_no_puzzle_or_not_open_is_refused(outside):  # R-X01
    for command in (act.BeginPuzzle("nothing_of_it"), act.BeginPuzzle("climb", "a99")):
        assert isinstance(begin_puzzle(MODEL, command, outside), No)
