from dataclasses import replace

import pytest
from msgspec import structs

from kit.labs.laboratory import job
from onika.wire import act


@pytest.fixture
def watched(cinema):
    cinema.doc = cinema.open([job("aC"), job("bC")])
    cinema.look(cinema.film(cinema.doc))
    return cinema


def compared(cinema, path, **tolerance):
    answer = cinema.later(act.CompareWith(str(path), **tolerance))
    assert answer.no is None
    while cinema.environment.tree.review.difference is None:
        cinema.become()
    return cinema.environment.tree.review.difference


def test_the_first_difference_of_two_runs_is_found(watched):  # R-X05: side by side
    comparison_view = compared(watched, watched.film(watched.doc, "other", step=2.0))
    assert (comparison_view.at_s, comparison_view.variable) == (0.1, "flow0/A")
    assert str(comparison_view.text) == "flow0/A: 0.1 s, in the other 0.2 s"
    assert watched.environment.tree.review.other.name == "play"
    assert watched.glance(1.5, of_other=True).values["flow0/A"] == 3.0
    assert watched.later(act.Course("flow0/A", 0.0, 2.0, of_other=True)).value[0].most[-1] == 3.8


def test_what_lies_within_the_tolerance_is_no_difference(watched):  # R-X05
    other = watched.film(watched.doc, "other", step=2.0)
    assert str(compared(watched, other, part=1.0).text) == ""
    assert str(compared(watched, other, tolerance=2.0).text) == ""
    assert compared(watched, other, tolerance=1.0).at_s == 1.1


def test_runs_in_wall_time_may_differ_as_such_runs_do_unless_it_is_said(watched):  # R-X05
    other = watched.film(watched.doc, "other", step=1.002)
    comparison_view = compared(watched, other)
    assert (
        str(comparison_view.text) != "",
        comparison_view.tolerance,
        comparison_view.part,
        comparison_view.time_s,
    ) == (True, 0.0, 0.0, 0.0)
    watched.do(act.CompareWith(""))
    review_session = watched.environment.model.review_session
    view = structs.replace(review_session.subject.view, is_virtual=False)
    subject = replace(review_session.subject, view=view)
    watched.environment.model = replace(
        watched.environment.model, review_session=replace(review_session, subject=subject)
    )
    comparison_view = compared(watched, other)
    assert (str(comparison_view.text), comparison_view.tolerance, comparison_view.part, comparison_view.time_s) == (
        "",
        0.002,
        0.001,
        0.1,
    )
    assert comparison_view.is_of_places
    exactly = compared(watched, other, tolerance=0.0, part=0.0)
    assert (str(exactly.text) != "", exactly.is_of_places) == (True, False)


def test_an_action_that_is_another_is_told_in_the_words_of_its_icon(watched):  # R-X05
    watched.do(act.RemoveIcons(watched.doc, (1,)))
    comparison_view = compared(watched, watched.film(watched.doc, "other"))
    assert (comparison_view.at_s, comparison_view.variable) == (0.0, "")
    sides = [comparison_view.text.args[side].args["event"] for side in ("first", "second")]
    assert [str(side) for side in sides] == ["“a job” begins", "“a job” begins"]


def test_the_other_one_can_be_put_away(watched):
    compared(watched, watched.film(watched.doc, "other"))
    other = watched.environment.model.review_session.other
    watched.do(act.CompareWith(""))
    assert other.away.is_set() and watched.environment.tree.review.other is None
    assert not watched.environment.model.review_session.subject.away.is_set()


def test_what_cannot_be_compared_is_refused(watched, tmp_path):
    assert "cannot be looked at" in str(watched.later(act.CompareWith(str(tmp_path / "none.mcap"))).no.reason)
    fields = watched.no(act.CompareWith("x", tolerance=-1.0)).fields
    assert {name: reason.key for name, reason in fields.items()} == {"tolerance": "run.zero_or_more"}
    watched.do(act.CloseRecording())
    assert "open one first" in str(watched.no(act.CompareWith("x")).reason)


def test_one_that_is_closed_while_another_is_read_is_not_compared(watched):
    given = []
    path = watched.film(watched.doc, "other")
    watched.environment.do(act.CompareWith(str(path)), "me", given.append)
    watched.do(act.CloseRecording())
    while not given:
        watched.become()
    assert "put away" in str(given[0].no.reason)


def test_nobody_hears_of_a_difference_that_is_not_wanted_any_more(watched):
    watched.later(act.CompareWith(str(watched.film(watched.doc, "other", step=2.0))))
    watched.do(act.CloseRecording())
    watched.look(watched.film(watched.doc, "third"))
    assert watched.environment.tree.review.difference is None


def test_why_two_cannot_be_compared_is_told_in_place_of_a_difference(watched):
    watched.environment.model.review_session.subject.path.write_bytes(b"")
    comparison_view = compared(watched, watched.film(watched.doc, "other"))
    assert "cannot be compared" in str(comparison_view.text)


def test_numbers_have_as_many_digits_as_tell_them_apart(cinema):  # R-X05
    doc = cinema.open([job("aC")])
    for name, value in (("one", 0.000190467072), ("same", 0.0001904670721), ("two", 0.0002047521024)):
        tape = cinema.tape(doc, name)
        tape.variable("Q^_REF", "double", (0.0, value), unit="rad/s")
        tape.end()
    cinema.look(cinema.base.path / "one.mcap")
    far = compared(cinema, cinema.base.path / "two.mcap").text
    assert str(far) == "flow0/Q^_REF: 0.0001905 rad/s, in the other 0.0002048 rad/s"
    near = compared(cinema, cinema.base.path / "same.mcap").text
    assert str(near) == "flow0/Q^_REF: 0.000190467072 rad/s, in the other 0.0001904670721 rad/s"


def test_arrays_of_other_sizes_are_told_by_how_many_values_there_are(cinema):  # R-X05: another robot
    doc = cinema.open([job("aC")])
    for name, size, values in (("four", "double[4,4]", [0.0] * 16), ("six", "double[6,4]", [0.0] * 24)):
        tape = cinema.tape(doc, name)
        tape.variable("DH", size, (0.0, values))
        tape.end()
    cinema.look(cinema.base.path / "four.mcap")
    comparison_view = compared(cinema, cinema.base.path / "six.mcap")
    assert str(comparison_view.text) == "flow0/DH: 4 × 4 values, in the other 6 × 4 values"
