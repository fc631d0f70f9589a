from onika.desk.upper.review.looking import Looking
from onika.testing.laboratory import job


def test_one_is_looked_at_and_perhaps_another_beside_it(cinema):  # R-X05
    cinema.look(cinema.film(cinema.open([job("aC")])))
    subject = cinema.environment.model.looking.subject
    alone, both = Looking(subject), Looking(subject, subject)
    assert (alone.one(of_other=False), alone.one(of_other=True)) == (subject, None)
    assert (alone.view.other, both.view.other) == (None, subject.view)
