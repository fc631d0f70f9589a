from kit.desk.review_fixture import ReviewFixture
from kit.labs.laboratory import job


def test_each_action_of_a_film_takes_a_second(tmp_path):  # R-X05
    cinema = ReviewFixture(tmp_path)
    doc = cinema.open([job("aC"), job("bC")])
    view = cinema.look(cinema.film(doc))
    assert [(passage.name, passage.begin_s, passage.end_s) for passage in view.flows["flow0"].passages] == [
        ("a job", 0.0, 1.0),
        ("a job", 1.0, 2.0),
    ]
    assert cinema.glance(1.5).run.flows["flow0"].step == 2
    assert cinema.glance(1.5).values["flow0/A"] == 1.5
