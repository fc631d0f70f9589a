import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.task import Task
from onika.wire import act, page


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (Task("a", "a", outvar=("Q",), frequency=1.0),))


def test_a_refused_act_is_no_done_one_and_the_other_way_round(sitting):
    with pytest.raises(AssertionError, match="was refused"):
        sitting.do(act.Undo("c1"))
    with pytest.raises(AssertionError, match="was not refused"):
        sitting.no(act.New())


def test_a_patch_that_says_too_little_is_found(sitting):
    sitting.new("a")
    with pytest.raises(AssertionError, match="copy differs"):
        sitting.patch(page.Patch(99, ((("documents", "c1", "name"), "other"),)))
