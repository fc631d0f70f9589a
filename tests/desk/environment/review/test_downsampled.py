import pytest

from kit.labs.laboratory import job
from onika.wire import act


@pytest.fixture
def watched(cinema):
    doc = cinema.open([job("aC"), job("bC"), job("cC")])
    cinema.look(cinema.film(doc))
    return cinema


def test_a_variable_is_read_once_aside_and_then_answered_at_once(watched):  # R-X05: plots
    (first,) = watched.later(act.Course("flow0/A", 0.0, 3.0, points=3)).value
    assert (str(first.label), first.unit, first.at_s) == ("A", "s", (0.0, 1.0, 2.0))
    assert (first.least, first.most) == ((0.0, 1.0, 2.0), (0.9, 1.9, 2.9))
    (again,) = watched.do(act.Course("flow0/A", 1.05, 1.06, points=10))
    assert again.most == (1.0,)


def test_words_have_no_course_and_what_was_not_recorded_is_refused(watched):
    assert watched.do(act.Course("flow0/WORD", 0.0, 3.0)) == ()
    assert str(watched.no(act.Course("flow0/NOTHING", 0.0, 3.0)).reason) == "flow0/NOTHING is not in film.mcap"


@pytest.mark.parametrize(
    ("begin_s", "end_s", "points"), [(3.0, 1.0, 10), (0.0, 3.0, 0), (0.0, 3.0, -7), (-9.0, -8.0, 5), (-1e308, 1e308, 1)]
)
def test_odd_stretches_are_answered_with_what_is_there(watched, begin_s, end_s, points):
    (course,) = watched.later(act.Course("flow0/A", begin_s, end_s, points)).value
    assert len(course.at_s) == len(course.least) == len(course.most) <= 1


def test_a_file_that_is_put_away_meanwhile_is_read_to_its_end(watched):
    given = []
    watched.environment.do(act.Course("flow0/A", 0.0, 3.0), "me", given.append)
    watched.do(act.CloseRecording())
    while not given:
        watched.become()
    assert str(given[0].value[0].label) == "A"
