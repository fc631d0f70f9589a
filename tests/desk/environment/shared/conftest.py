import pytest

from kit.desk.review_fixture import ReviewFixture
from kit.labs.laboratory import job


@pytest.fixture
def cinema(tmp_path):
    return ReviewFixture(tmp_path)


@pytest.fixture
def watched(cinema):
    """Somebody looks at a run of three actions of a second each."""
    cinema.doc = cinema.open([job("aC"), job("bC"), job("cC")])
    cinema.look(cinema.film(cinema.doc))
    cinema.subject = cinema.environment.model.review_session.subject
    return cinema
