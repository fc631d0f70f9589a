import pytest

from kit.faults.fault_planting import FaultyRuntime


@pytest.fixture
def runtime():
    return FaultyRuntime().start()


def last_values(foresight):
    notes = [reason for reason in foresight.notes if reason.key == "foresight.last_value"]
    return [(note.args["task"], note.args["names"]) for note in notes]


def changes(foresight):
    return [(effect.subject, effect.after) for effect in foresight.effects]


def test_hardware_that_read_a_task_that_fails_holds(runtime):  # R-X24, law 4
    (foresight,) = runtime.foresee("task", "hand/push2")
    assert changes(foresight) == [("hand/push2", "ERROR"), ("hand/mass2", "ERROR"), ("yard:m1", "HELD")]
    assert last_values(foresight) == []


def test_who_read_a_task_that_is_late_goes_on_with_the_last_value(runtime):  # R-X24
    (foresight,) = runtime.foresee("late", "hand/push2")
    assert last_values(foresight) == [("hand/mass2", ("FORCE",))]
    assert "foresight.drives_driven" in [part.key for part in foresight.answer.args["parts"]]


def test_hardware_whose_writer_dies_with_another_unit_holds(runtime):  # R-X24, law 4
    (foresight,) = runtime.foresee("unit-killed", "rt1")
    assert [change for change in changes(foresight) if change[0].endswith("2") or change[0] == "yard:m1"] == [
        ("hand/push2", "KILLED"), ("hand/mass2", "ERROR"), ("yard:m1", "HELD"),
    ]  # fmt: skip


def test_hardware_that_a_number_reaches_only_through_others_is_named(runtime):  # R-X24, law 5
    (foresight,) = runtime.foresee("nan", "hand/X")
    assert foresight.effects == ()
    assert [(note.key, note.args["task"]) for note in foresight.notes] == [("foresight.passed_on", "hand/mass2")]
