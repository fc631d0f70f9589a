import pytest

from kit.cinema import Cinema


@pytest.fixture
def cinema(tmp_path):
    return Cinema(tmp_path)
