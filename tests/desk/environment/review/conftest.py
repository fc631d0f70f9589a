import pytest

from onika.testing.cinema import Cinema


@pytest.fixture
def cinema(tmp_path):
    return Cinema(tmp_path)
