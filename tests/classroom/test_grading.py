"""What is expected of a hand-in, tried on real runs in virtual time."""

import shutil

import msgspec
import pytest

from onika.classroom.grading import Grading, graded
from onika.store.shipped import shipped

pytestmark = pytest.mark.site


@pytest.fixture
def handed_in(tmp_path):
    folder = tmp_path / "0001"
    (folder / "appl").mkdir(parents=True)
    shutil.copy(shipped() / "boxes" / "appl" / "go_home.appl", folder / "appl")
    return folder


def test_a_hand_in_is_run_and_each_expectation_is_told(handed_in):  # R-X25
    made = graded(Grading(("Q_MEZ[0] > -9", "LAMP == 1")), 4, handed_in)
    assert made.number == 4
    assert [(one.text, one.holds) for one in made.expectations] == [("Q_MEZ[0] > -9", True), ("LAMP == 1", False)]
    assert made.score == (1, 2)
    assert msgspec.json.decode(msgspec.json.encode(made), type=type(made)) == made


def test_what_cannot_be_run_holds_nothing_and_says_why(handed_in):  # R-X25
    path = handed_in / "appl" / "go_home.appl"
    path.write_text(path.read_text().replace("jmoveC", "nosuchjob"))
    (one,) = graded(Grading(("Q_MEZ[0] > -9",)), 1, handed_in).expectations
    assert (one.holds, bool(one.why)) == (False, True)


def test_a_hand_in_without_the_application_that_is_meant_has_nothing_to_run(handed_in):
    made = graded(Grading(("LAMP == 1",), program="assemble"), 1, handed_in)
    assert (made.why.key, made.score) == ("class.nothing_to_run", (0, 1))
