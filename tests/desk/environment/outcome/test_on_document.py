import pytest

from kit.environment_fixture import EnvironmentFixture
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.outcome import No
from onika.wire import act

ACTS = (
    act.Place("c9", "a", 0, 0),
    act.Remove("c9", ("a",)),
    act.Move("c9"),
    act.Save("c9"),
    act.Close("c9"),
    act.Copy("c9", ("a",)),
    act.Check("c9"),
    act.Draft("c9"),
    act.Toggle("c9", "a"),
    act.Connect("c9"),
    act.Group("c9", "g", ("a",)),
    act.Rate("c9", "a", 1.0),
    act.Take("c9"),
)


@pytest.mark.parametrize("asked", ACTS, ids=lambda asked: type(asked).__name__)
def test_an_act_on_a_document_that_was_closed_is_refused_in_one_sentence(tmp_path, asked):
    sitting = EnvironmentFixture(tmp_path)
    found = HANDLERS[type(asked)](sitting.environment.model, asked, sitting.surroundings)
    assert found == No("this configuration is no longer open")
