from onika.desk.plan.target_inputs import measured_kinds, paired, takes, unit_of_variable
from onika.model.syntax import DataItem
from onika.model.task import Task
from onika.store.site import open_site
from onika.wire.sheet import InputSheet, PortSheet
from onika.words.value import ValueType

SYNTAX, _ = open_site([], {}, None).syntax()
MOVE = Task("move", "move", invar=("Q",), object_type="Joint job", aliases=(("Q", "Q_MEZ"),))
ENDPOINT = InputSheet("endpoint", "double[NDOF]", "rad", "", None, None, None)
NAME = InputSheet("name", "string", "-", "", None, None, None)


def port(name, unit):
    return PortSheet("INVAR", name, "double", unit, "")


def test_a_task_takes_the_target_of_its_job():  # R-D08
    assert takes(MOVE, SYNTAX.find("Joint object"), SYNTAX)
    assert not takes(MOVE, SYNTAX.find("Cartesian object"), SYNTAX)


def test_data_and_inputs_are_paired_as_long_as_they_are_of_one_type():  # R-B10
    items = (DataItem("a", ValueType.DOUBLE, 6), DataItem("b", ValueType.DOUBLE, 1))
    assert [item.name for item, _ in paired(items, (ENDPOINT, NAME))] == ["a"]


def test_the_units_of_data_are_those_of_the_inputs_that_take_them():  # R-C30
    units = {kind.name: units for kind, units in measured_kinds(SYNTAX, [(MOVE, (ENDPOINT, NAME))])}
    assert units["Joint object"] == {"endpoint": "rad"}
    assert units["Cartesian object"] == {}
    assert "Joint job" not in units
    assert measured_kinds(None, []) == []


def test_a_variable_has_the_unit_on_which_its_tasks_agree():  # R-C30
    other = Task("other", "other", invar=("Q_MEZ",))
    assert unit_of_variable("Q_MEZ", [(MOVE, (port("Q", "rad"),)), (other, (port("Q_MEZ", "-"),))]) == "rad"
    assert unit_of_variable("Q_MEZ", [(MOVE, (port("Q", "rad"),)), (other, (port("Q_MEZ", "m"),))]) == ""
    assert unit_of_variable("Q", [(MOVE, (port("Q", "rad"),))]) == ""
