import pytest

from kit.desk.review_fixture import ReviewFixture


@pytest.fixture
def cinema(tmp_path):
    return ReviewFixture(tmp_path)
