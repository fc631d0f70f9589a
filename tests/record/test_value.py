import json
import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.record import value
from onika.words import letters
from onika.words.shape import Shape

REALS = st.floats(allow_nan=True, allow_infinity=True, width=64)


def same(first, other):
    return (math.isnan(first) and math.isnan(other)) or first == other


@given(st.lists(REALS, min_size=1, max_size=12))
def test_every_double_comes_back_as_it_was(numbers):  # R-X05
    shape = Shape.parse(f"double[{len(numbers)}]")
    body = value.encoder(shape)([np.array(numbers).tobytes()])[0]
    assert all(map(same, value.decode(body, shape), numbers))


@given(REALS)
def test_a_lone_double_is_no_list(number):  # R-X05
    body = value.encoder(Shape.parse("double"))([np.float64(number).tobytes()])[0]
    assert same(value.decode(body, Shape.parse("double")), number)


@given(st.integers(-(2**63), 2**63 - 1))
def test_every_whole_number_comes_back_as_it_was(number):  # R-X05
    body = value.encoder(Shape.parse("long"))([np.int64(number).tobytes()])[0]
    assert value.decode(body, Shape.parse("long")) == number


@given(st.text(max_size=60).filter(lambda text: "\0" not in text))
def test_every_text_comes_back_as_it_was(text):  # R-X05
    shape = Shape.parse("line")
    body = value.encoder(shape)([letters.encode(text, shape.type, shape.size)])[0]
    assert value.decode(body, shape) == text


@given(st.lists(st.tuples(REALS, REALS), min_size=1, max_size=6))
def test_many_at_once_stand_there_as_each_alone(rows):  # R-X05
    encoded = value.encoder(Shape.parse("double[2]"))
    values = [np.array(row).tobytes() for row in rows]
    assert encoded(values) == [encoded([number])[0] for number in values]


def test_a_matrix_is_flat_in_the_file_and_deep_when_read():  # viewers know no lists of lists
    shape = Shape.parse("double[2,3]")
    body = value.encoder(shape)([np.arange(6.0).tobytes()])[0]
    assert json.loads(body) == {"value": [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]}
    assert value.decode(body, shape) == [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]]


def test_a_picture_is_base64():
    shape = Shape.parse("byte[10,10]")
    data = bytes(range(100))
    body = value.encoder(shape)([data])[0]
    assert len(body) < 200
    assert value.decode(body, shape)[3][4] == 34


@pytest.mark.parametrize(
    ("shape", "kind"),
    [("double", "number"), ("int", "integer"), ("line", "string"), ("double[6]", "array"), ("byte[9,9]", "string")],
)
def test_the_schema_is_an_object_with_a_value_and_its_unit(shape, kind):  # as Foxglove asks
    schema = json.loads(value.schema(Shape.parse(shape), "rad"))
    assert schema["type"] == "object"
    assert schema["properties"]["value"]["type"] == kind
    assert schema["properties"]["value"]["description"].endswith("[rad]")
    assert value.title(Shape.parse(shape), "rad") == f"onika.{shape} rad"


def test_a_matrix_is_flat_where_that_is_wanted():  # R-X05
    shape = Shape.parse("double[2,2]")
    assert value.flat(b'{"value":[1.0,2.0,3.0,4.0]}', shape) == [1.0, 2.0, 3.0, 4.0]
    assert value.flat(b'{"value":7}', Shape.parse("int")) == [7]
