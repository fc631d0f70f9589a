from types import SimpleNamespace

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.classroom.seat_progress import SeatProgress
from onika.desk.environment.environment import ActAnswer
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import RunView
from onika.words.reason import Reason


class Followed:
    """An environment whose progress is followed, with a time that is set."""

    def __init__(self, folder):
        self.desk = EnvironmentFixture(folder, (Task("a", "a", outvar=("Q",), frequency=1.0),)).environment
        self.now_s = 100.0
        self.progress = SeatProgress(lambda: self.desk.model, lambda: self.now_s)
        self.desk.observers.append(self.progress.begun)
        self.desk.followers.append(self.progress.changed)

    def do(self, command):
        self.desk.do(command, "Ana", lambda _: None)

    @property
    def standing(self):
        return self.progress.standing(1, 0)


@pytest.fixture
def followed(tmp_path):
    return Followed(tmp_path)


def test_a_lesson_that_is_done_is_a_step_forward_and_nothing_else_is_believed(followed):  # R-X25
    def noted(course, lessons, of, event="pass_lesson"):
        followed.do(act.Note(event, course, associated=lessons, associated_id=of))
        standing = followed.standing
        return standing.course, standing.lessons, standing.lessons_of

    followed.now_s += 60.0
    assert noted("loops", "0", "5") == ("loops", 0, 5)
    assert followed.standing.idle_s == 60.0
    assert noted("loops", "2", "5") == ("loops", 2, 5)
    assert followed.standing.idle_s == 0.0
    for course, lessons, of in (("<b>", "3", "5"), ("loops", "-1", "5"), ("loops", "3", "9" * 9), ("x" * 99, "1", "2")):
        assert noted(course, lessons, of) == ("loops", 2, 5)
    assert noted("loops", "4", "5", "read_help") == ("loops", 2, 5)


def test_an_act_that_changes_something_is_a_step_forward(followed):  # R-X25
    followed.now_s += 60.0
    assert (followed.standing.steps, followed.standing.idle_s) == (0, 60.0)
    followed.do(act.New())
    assert (followed.standing.steps, followed.standing.idle_s) == (1, 0.0)
    followed.now_s += 5.0
    assert followed.standing.idle_s == 5.0


def test_looking_is_none_and_what_is_refused_is_told_with_its_age(followed):  # R-X25
    followed.now_s += 60.0
    followed.progress.acted(act.Watch(), ActAnswer())
    followed.do(act.Save("c9"))
    followed.now_s += 7.0
    assert (followed.standing.steps, followed.standing.idle_s) == (0, 67.0)
    assert followed.standing.refusal
    assert followed.standing.refusal_s == 7.0


def test_what_the_door_refuses_counts_too_and_who_comes_back_was_not_stuck(followed):
    followed.now_s += 600.0
    followed.progress.refused(Reason.of("class.learner_frozen"))
    assert followed.standing.refusal.key == "class.learner_frozen"
    followed.progress.came()
    assert followed.standing.idle_s == 0.0


@pytest.mark.parametrize(("state", "says"), [("beginning", "starting"), ("running", "running")])
def test_a_run_whose_runtime_starts_says_so(state, says):  # R-X25
    run = SimpleNamespace(view=RunView("a1", "go_home", 1, state=state), is_over=False)
    model = SimpleNamespace(applications={}, run=run)
    assert SeatProgress(lambda: model, lambda: 0.0).standing(1, 0).run == says
