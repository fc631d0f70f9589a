"""The state-variable table."""

import numpy as np
import pytest

from onika.ring.segment import Segment
from onika.runtime.table import Table, value_of
from onika.words import letters
from onika.words.shape import Shape
from onika.words.value import ValueType


@pytest.fixture
def table():
    segment = Segment.create("test", 1 << 16)
    yield Table(segment)
    segment.close()


def shape(text):
    return Shape.parse(text)


def test_a_new_table_is_zeroed_and_so_are_new_entries(table):  # law 4
    table.entry("Q_MEZ", shape("double[3]"))
    assert table.is_zeroed
    assert table.value("Q_MEZ").tolist() == [0.0, 0.0, 0.0]
    table.ring("Q_MEZ").write(np.ones(3).tobytes())
    assert not table.is_zeroed


def test_an_entry_is_made_once(table):
    one = table.entry("Q_MEZ", shape("double[3]"))
    assert table.entry("Q_MEZ", shape("double[3]")) == one
    assert list(table.entries) == ["Q_MEZ"]


def test_entries_do_not_overlap(table):
    for number, text in enumerate(["byte", "double[9]", "string", "short[65]"]):
        entry = table.entry(f"V{number}", shape(text))
        table.ring(f"V{number}").write(bytes([number + 1]) * entry.shape.size)
    assert [table.ring(name).read()[:1] for name in table.entries] == [b"\1", b"\2", b"\3", b"\4"]


@pytest.mark.parametrize("other", ["double[4]", "float[3]", "double"])
def test_a_declaration_of_another_type_or_shape_is_refused(table, other):  # law 7
    table.entry("Q_MEZ", shape("double[3]"))
    with pytest.raises(ValueError, match=r"Q_MEZ is double\[3\] in this subsystem, found "):
        table.entry("Q_MEZ", shape(other))
    assert table.entries["Q_MEZ"].shape == shape("double[3]")


def test_a_table_that_is_full_says_so(table):
    with pytest.raises(ValueError, match="no room for PICTURE"):
        table.entry("PICTURE", shape("byte[128,128]"))
    assert table.entries == {}


@pytest.mark.parametrize(
    ("text", "value"),
    [("double", 0.5), ("int", -3), ("byte[2]", [1, 255]), ("double[2,2]", [[1.0, 2.0], [3.0, 4.0]])],
)
def test_numbers_are_plain_and_vectors_are_arrays(text, value):  # R-A03
    data = np.array(value, dtype=shape(text).type.code).tobytes()
    found = value_of(data, shape(text))
    assert np.asarray(found).tolist() == value
    assert isinstance(found, np.ndarray) == isinstance(value, list)


def test_letters_are_str_and_several_of_them_lists():
    assert value_of(letters.encode("on", ValueType.STRING, 256), shape("string")) == "on"
    assert value_of(b"abc", shape("char[3]")) == ["a", "b", "c"]


def test_values_are_copies(table):
    table.entry("X", shape("double[2]"))
    before = table.value("X")
    table.ring("X").write(np.ones(2).tobytes())
    assert before.tolist() == [0.0, 0.0]


def test_only_variables_that_are_there_have_values(table):
    table.entry("X", shape("double"))
    assert table.values(["X", "Y"]) == {"X": 0.0}
    with pytest.raises(KeyError):
        table.value("Y")
