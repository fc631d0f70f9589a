from dataclasses import replace

import pytest

from onika.desk.environment.icons.measured_variables import MeasuredVariable, measures_of, values_of
from onika.desk.environment.initial_model import opened
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.words.value import ValueType

MODEL, _ = opened(open_site([], {}, None), None, {})
SHEETS = {
    path.stem: sheet_of(load(path.read_text("utf-8"), str(path), path.stem)) for path in shipped().glob("*/module/*.py")
}
KNOWING = replace(MODEL, libraries=replace(MODEL.libraries, sheets=SHEETS))


def measures(name, model=KNOWING):
    return [
        (measure.item, measure.variable, measure.is_frame) for measure in measures_of(model, model.syntax.find(name))
    ]


def test_what_a_task_goes_by_says_what_its_target_says():  # R-D13
    assert measures("Joint object") == [("endpoint", "Q_MEZ", False)]
    assert ("pose", "X_MEZ", True) in measures("Cartesian object")
    for name in ("Pause object", "Number object", "File name object", "Level object", "Joint job"):
        assert measures(name) == [], name


def test_before_a_runtime_has_said_what_is_read_the_code_does():
    assert measures("Joint object", MODEL) == [("endpoint", "Q_MEZ", False)]


@pytest.mark.parametrize(
    ("measure", "value", "expected"),
    [
        (MeasuredVariable("a", 2, ValueType.DOUBLE, "Q"), [1.0, 2], (1.0, 2.0)),
        (MeasuredVariable("a", 4, ValueType.DOUBLE, "Q"), [[1, 2], [3, 4]], (1.0, 2.0, 3.0, 4.0)),
        (MeasuredVariable("a", 1, ValueType.INT, "N"), 3.0, (3,)),
    ],
)
def test_values_of_a_variable_become_those_of_a_target(measure, value, expected):  # R-D13
    assert values_of(measure, value) == expected


def test_too_few_values_are_none_of_a_target():  # R-D13
    assert str(values_of(MeasuredVariable("a", 3, ValueType.DOUBLE, "Q"), [1.0])) == "Q has 1 values and a 3"


def test_other_numbers_of_values_fit_only_where_a_constant_says_how_many():  # R-D13
    four = [0.1, 0.2, 0.3, 0.4]
    fixed = MeasuredVariable("endpoint", 6, ValueType.DOUBLE, "Q_MEZ")
    assert str(values_of(fixed, four)) == "Q_MEZ has 4 values and endpoint 6"
    assert values_of(replace(fixed, dimension="NDOF"), four) == tuple(four)
