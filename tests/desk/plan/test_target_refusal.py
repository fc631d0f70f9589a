from onika.desk.plan.target_refusal import unfit
from onika.model.rules.target_fit import VariableValue
from onika.model.syntax import DataItem, IconType
from onika.words.value import ValueType


def kind(name, count, dimension=""):
    return IconType(name, 1, 2, (DataItem("values", ValueType.DOUBLE, count, dimension),))


def test_what_a_variable_is_and_what_is_wanted_is_said():  # R-C30, R-X01
    variable = VariableValue("STIFF", "double[2,2]", [[1.0, 0.0], [0.0, 1.0]], "N/m")
    text = str(unfit(variable, [(kind("Cartesian object", 9), {}), (kind("Pause object", 1), {})]))
    assert text == (
        "STIFF is double[2,2] N/m, which no type of target takes: "
        "Cartesian target: values takes 9 values, this is double[2,2]; "
        "Pause target: values takes 1 value, this is double[2,2]"
    )


def test_of_many_types_three_are_named():
    variable = VariableValue("T", "string", "now")
    text = str(unfit(variable, [(kind(f"Nr{number} object", 1), {}) for number in range(9)]))
    assert [f"Nr{number}" in text for number in range(5)] == [True, True, True, False, False]
