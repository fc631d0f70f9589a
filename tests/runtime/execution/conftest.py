import pytest

from kit.runtime.task_place import Place


@pytest.fixture
def place():
    place = Place()
    yield place
    place.segment.close()
