import pytest

from kit.fault_planting import FaultyRuntime


@pytest.fixture
def runtime():
    return FaultyRuntime().start()


def test_who_read_a_task_that_fails_goes_on_with_the_last_value(runtime):  # R-X24
    (foresight,) = runtime.foresee("task", "hand/push2")
    notes = [reason for reason in foresight.notes if reason.key == "foresight.last_value"]
    assert [(note.args["task"], note.args["names"]) for note in notes] == [("hand/mass2", ("FORCE",))]
    assert "foresight.drives_driven" in [part.key for part in foresight.answer.args["parts"]]


def test_hardware_that_a_number_reaches_only_through_others_is_named(runtime):  # R-X24, law 5
    (foresight,) = runtime.foresee("nan", "hand/X")
    assert foresight.effects == ()
    assert [(note.key, note.args["task"]) for note in foresight.notes] == [("foresight.passed_on", "hand/mass2")]
