from kit.labs.laboratory import job
from onika.desk.environment.run_state.review_session import ReviewSession
from onika.wire import act


def test_one_is_looked_at_and_perhaps_another_beside_it(cinema):  # R-X05
    cinema.look(cinema.film(cinema.open([job("aC")])))
    subject = cinema.environment.model.review_session.subject
    alone, both = ReviewSession(subject), ReviewSession(subject, subject)
    assert (alone.subject_of(of_other=False), alone.subject_of(of_other=True)) == (subject, None)
    docs = cinema.environment.model.applications
    assert (alone.view(docs).other, both.view(docs).other) == (None, subject.view)


def test_an_application_that_was_closed_meanwhile_is_not_named(cinema):  # R-X05
    cinema.look(cinema.film(cinema.open([job("aC")])))
    doc = cinema.environment.tree.review.recording.doc
    assert doc in cinema.environment.model.applications
    cinema.do(act.Close(doc, discards=True))
    assert cinema.environment.tree.review.recording.doc == ""
    assert cinema.glance(0.5).run.name == "play"
