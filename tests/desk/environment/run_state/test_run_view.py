import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.run_state.run_view import is_question, left_for, loops, stop_view, tag
from onika.wire import act, event
from onika.wire.view import ChoiceView
from onika.words.reason import Reason

WHERE = ("flow0", "b", "bC", 1, "play.appl:2", Reason.plain("cycle: no glass"), "b.py", 7)


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


@pytest.fixture
def run(play):
    play.run(play.open([job("aC"), job("bC")]))
    play.began(1)
    play.tell(event.Failed("flow0", "b", Reason.plain("cycle: no glass"), "b.py", 7, "Traceback …", 2.0, "cycle"))
    return play.environment.model.run


def explained(choices=(), courses=()):
    return event.Explained(*WHERE, (("flow1", "meet"),), courses, choices, 2.0, "error", "a")


def test_a_standstill_leads_to_its_step_and_its_code(run):  # R-X06
    shown = stop_view(run, explained())
    assert (shown.step, shown.index, shown.task, shown.suspect) == (2, 1, "b", "a")
    assert (shown.path, shown.line, shown.traceback) == ("b.py", 7, "Traceback …")
    assert shown.waiting == (("flow1", "meet"),)


def test_choices_are_acts_of_steering_and_one_that_leaves_something_open_is_none_yet(run):  # R-E08
    repeats, leaps, passes = map(Reason.plain, ("repeats it", "goes on with another one", "goes on alone"))
    shown = stop_view(run, explained((("clear", repeats), ("skip flow9 N", leaps), ("pass flow1", passes))))
    assert shown.choices == (
        ChoiceView("clear", repeats, "", act.Steer("clear", run.doc)),
        ChoiceView("skip", leaps, "flow9", None),
        ChoiceView("pass", passes, "flow1", act.Steer("pass flow1", run.doc)),
    )


def test_of_long_courses_the_newest_value_is_kept(run):  # R-X06
    times = tuple(float(index) for index in range(1000))
    (course,) = stop_view(run, explained(courses=(event.Course("Q", "rad", times, times),))).courses
    assert len(course.at_s) <= 120 and course.at_s[-1] == course.values[-1] == 999.0


def test_a_choice_of_one_other_action_needs_no_choosing(run):  # R-E13
    skips = [explained(((words, Reason.plain("the same")),)) for words in ("skip N", "skip flow0 N", "skip flow7 N")]
    acts = [stop_view(run, skip).choices[0].act for skip in skips]
    assert acts == [act.Steer("skip flow0 1", run.doc), act.Steer("skip flow0 1", run.doc), None]


def test_a_stop_is_told_in_the_words_of_the_icons(play):  # R-X06
    play.run(play.open([job("bC").replace("a job", "hold still")]))
    clears = Reason.of("host.clears", tasks=("b",))
    choices = (("clear", Reason.of("host.and_repeats", what=clears, action="bC")),)
    shown = stop_view(play.environment.model.run, event.Explained(*WHERE[:3], 0, *WHERE[4:], (), (), choices, 2.0))
    (choice,) = shown.choices
    assert (shown.action, str(choice.meaning)) == (
        "hold still",
        "clears b and repeats “hold still” with the same target",
    )


def test_that_a_task_asks_is_no_news_of_its_own():  # R-E15
    assert is_question(Reason.of("engine.asks", where="x: b"))
    assert is_question(Reason.of("engine.asks_again", where="x: b", why="too far"))
    assert not is_question(Reason.of("engine.in_error", where="x: b", why="it asks a lot of the arm"))
    assert not is_question(Reason.plain("x: b asks"))


def test_who_waits_for_ever_for_whom(play):  # R-X03
    play.run(play.open([job("aC")], [job("bC")], [job("cC")], parallel=True))
    for flow, other in (("flow1", "flow0"), ("flow2", "flow1")):
        play.tell(event.Moved(flow, "waiting", 0, 1.0, "play meet", (other,)))
        play.tell(
            event.Explained(
                flow,
                "",
                "",
                0,
                "",
                Reason.plain("waits"),
                "",
                0,
                (),
                (),
                (("abort", Reason.plain("ends")),),
                2.0,
                "deserted",
            )
        )
    run = play.environment.model.run
    assert (left_for(run, "flow0"), left_for(run, "flow2")) == ({"flow1", "flow2"}, {"flow2"})


def test_tags_and_loops_are_called_as_in_the_file():
    assert (tag("play/inner#2 meet"), tag("meet"), tag("")) == ("meet", "meet", "")
    assert loops(("inner/round", "twice#2")) == ("round", "twice")
