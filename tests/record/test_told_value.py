import json
import math

import pytest

from onika.record import value
from onika.record.told_value import encoded, shape_of


@pytest.mark.parametrize(
    ("told", "shape"),
    [
        (1.5, "double"),
        (3, "long"),
        ("on", "string"),
        ([1.0, 2.0], "double[2]"),
        ((1, 2.5), "double[2]"),
        ([[1, 2, 3], [4, 5, 6]], "long[2,3]"),
    ],
)
def test_a_told_value_is_read_again_as_it_was(told, shape):  # R-X05
    found = shape_of(told)
    assert str(found) == shape
    plain = json.loads(json.dumps(told))
    assert value.decode(encoded(told, found), found) == plain


def test_what_has_no_end_or_is_no_number_stands_in_the_recording_too():  # R-X05
    told = [math.inf, -math.inf, math.nan]
    found = shape_of(told)
    read = value.decode(encoded(told, found), found)
    assert read[:2] == told[:2] and math.isnan(read[2])


@pytest.mark.parametrize("told", [b"picture", [], [[]], None, True, {"a": 1}])
def test_what_is_no_number_or_text_has_no_shape(told):  # R-X05
    assert shape_of(told) is None
