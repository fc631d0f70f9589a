import pytest
from hypothesis import given, strategies as st

from onika.model.pose_numbers import nine_of
from onika.model.rules.target_fit import TargetFit, VariableValue, fits_in, reasons_against, values_for
from onika.model.syntax import DataItem, IconType
from onika.words.reason import Reason
from onika.words.value import ValueType

JOINTS = DataItem("endpoint", ValueType.DOUBLE, 6, "NDOF")
DURATION = DataItem("duration", ValueType.DOUBLE, 1)
POSE = DataItem("pose", ValueType.DOUBLE, 9)
NUMBER = DataItem("number", ValueType.BYTE, 1)
WORD = DataItem("file", ValueType.STRING, 1)
JOINT = IconType("Joint object", 1, 2, (JOINTS, DURATION))
FRAME = [[1.0, 0.0, 0.0, 0.5], [0.0, -1.0, 0.0, 0.6], [0.0, 0.0, -1.0, 0.7], [0.0, 0.0, 0.0, 1.0]]
UNITS = {"endpoint": "rad", "duration": "s"}


def why(item, shape, value, unit="", wanted=""):
    reason = values_for(item, VariableValue("X", shape, value, unit), wanted)
    assert isinstance(reason, Reason), reason
    return reason.key


def test_a_vector_gives_the_datum_of_its_length_and_unit():  # R-C30
    angles = VariableValue("Q_MEZ", "double[6]", [0.1] * 6, "rad")
    assert fits_in(JOINT, angles, UNITS) == (TargetFit("Joint object", "endpoint", (0.1,) * 6),)


def test_a_robot_of_other_joints_gives_as_many_as_it_has():  # R-C30, R-D13
    assert values_for(JOINTS, VariableValue("Q", "double[4]", [0.1] * 4)) == (0.1,) * 4


def test_the_angles_of_six_joints_are_no_polynomial_of_one():  # R-C30, R-D13
    coefficients = DataItem("coefficients", ValueType.DOUBLE, 36, "NDOF", each=6)
    assert why(coefficients, "double[6]", [0.1] * 6) == "rules.fit_count"
    assert values_for(coefficients, VariableValue("C", "double[30]", [0.1] * 30)) == (0.1,) * 30


def test_a_number_gives_the_datum_of_one_number_only():  # R-C30
    assert fits_in(JOINT, VariableValue("T", "double", 2.5, "s"), UNITS) == (
        TargetFit("Joint object", "duration", (2.5,)),
    )


def test_a_frame_gives_the_nine_numbers_of_a_pose():  # R-C30, reading 44
    assert values_for(POSE, VariableValue("X_MEZ", "double[4,4]", FRAME)) == nine_of(FRAME)


def test_four_rows_that_are_no_frame_give_no_pose():  # R-C30
    assert why(POSE, "double[4,4]", [[1.0] * 4] * 4) == "rules.fit_frame"


def test_other_units_kinds_and_numbers_are_each_told():  # R-C30
    assert why(JOINTS, "double[6]", [1.0] * 6, "N", "rad") == "rules.fit_unit"
    assert why(NUMBER, "double", 1.0) == "rules.fit_kind"
    assert why(JOINTS, "string", "far") == "rules.fit_kind"
    assert why(DURATION, "double[2]", [1.0, 2.0]) == "rules.fit_count"
    assert why(POSE, "double[3,3]", [[1.0] * 3] * 3) == "rules.fit_count"
    assert why(NUMBER, "int", 300) == "rules.fit_value"


def test_a_number_that_is_none_makes_no_target():  # R-C30
    assert why(DURATION, "double", float("nan")) == "rules.fit_value"


def test_a_word_gives_a_word():  # R-C30
    assert values_for(WORD, VariableValue("ROBOT", "string", "puma")) == ("puma",)


def test_of_types_that_do_not_fit_those_that_come_nearest_are_named():  # R-C30, R-X01
    force = VariableValue("F_MEZ", "double[6]", [1.0] * 6, "N")
    names = IconType("File name object", 1, 2, (WORD,))
    against = reasons_against([(JOINT, UNITS), (names, {})], force)
    assert [(kind.name, str(reason)) for kind, reason in against] == [
        ("Joint object", "endpoint is in rad, this in N"),
    ]


@given(st.sampled_from(ValueType), st.sampled_from(ValueType))
def test_what_fits_is_a_value_of_the_datum(wanted, given_type):
    value = "x" if given_type.is_text or given_type is ValueType.CHAR else 7
    values = values_for(DataItem("d", wanted, 1), VariableValue("X", given_type.value, value))
    if not isinstance(values, Reason):
        assert all(wanted.fits(each) for each in values)


@pytest.mark.parametrize("unit", ["", "-"])
def test_a_unit_that_is_not_known_stands_in_no_way(unit):  # R-C30
    assert values_for(DURATION, VariableValue("T", "double", 1.0, unit), "s") == (1.0,)
