"""The state-variable table."""

import numpy as np
import pytest

from onika.ring.segment import Segment
from onika.runtime.table import Table, plain, value_of
from onika.words import letters
from onika.words.shape import Shape
from onika.words.value import ValueType


@pytest.fixture
def table():
    segment = Segment.create("test", 1 << 18)
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
    entry = table.entry("Q_MEZ", shape("double[3]"))
    assert table.entry("Q_MEZ", shape("double[3]")) == entry
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
        table.entry("PICTURE", shape("byte[512,512]"))
    assert table.entries == {}


@pytest.mark.parametrize(
    ("text", "value"),
    [("double", 0.5), ("int", -3), ("byte[2]", [1, 255]), ("double[2,2]", [[1.0, 2.0], [3.0, 4.0]])],
)
def test_numbers_are_plain_and_vectors_are_arrays(text, value):  # R-A03
    data = np.array(value, dtype=shape(text).type.code).tobytes()
    decoded = value_of(data, shape(text))
    assert np.asarray(decoded).tolist() == value
    assert isinstance(decoded, np.ndarray) == isinstance(value, list)


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


def test_a_dropped_variable_is_unknown_and_its_memory_stays(table):  # law 12
    table.entry("X", shape("double"))
    ring = table.ring("X")
    ring.write(np.array([2.5]).tobytes())
    table.drop("X")
    assert "X" not in table.entries
    with pytest.raises(KeyError):
        table.ring("X")
    assert value_of(ring.read(), shape("double")) == 2.5


def test_freed_memory_is_used_again_zeroed_and_armed(table):  # law 4, law 12, R-A12
    entry = table.entry("X", shape("double[3]"))
    table.ring("X").write(np.ones(3).tobytes())
    table.free(table.drop("X"))
    end = table.end
    again = table.entry("Y", shape("double[2]"))
    assert (again.offset, table.end) == (entry.offset, end)
    assert table.value("Y").tolist() == [0.0, 0.0]
    assert table.ring("Y").faults() == []
    assert table.is_zeroed


def test_freed_memory_is_not_used_for_what_has_no_room_in_it(table):  # law 12
    table.entry("X", shape("double"))
    table.free(table.drop("X"))
    end = table.end
    assert table.entry("PICTURE", shape("byte[256]")).offset == end


def test_a_dropped_variable_is_put_back_with_its_value(table):  # R-X10
    entry = table.entry("X", shape("double"))
    table.ring("X").write(np.array([2.5]).tobytes())
    table.drop("X")
    table.free(table.drop(table.entry("X", shape("double[9]")).name))
    table.put_back(entry)
    assert table.entries["X"] == entry
    assert table.value("X") == 2.5


def test_a_name_can_have_another_shape_once_the_old_one_is_dropped(table):  # law 12
    table.entry("X", shape("double"))
    table.drop("X")
    assert table.entry("X", shape("double[2]")).shape == shape("double[2]")


def test_no_memory_is_lost_whatever_comes_and_goes(table):  # law 12
    for number in range(3000):
        table.entry("X", shape(f"double[{1 + number % 40}]"))
        table.free(table.drop("X"))
    assert table.end < table.segment.size // 4


def test_values_travel_as_plain_lists_and_numbers():
    assert plain(np.array([[1.0, 2.0]])) == [[1.0, 2.0]]
    assert plain("word") == "word"


def test_a_table_that_is_closed_holds_no_memory_though_somebody_refers_to_it(table):  # R-F01
    table.entry("Q_MEZ", shape("double[3]"))
    ring, segment = table.ring("Q_MEZ"), table.segment
    table.close()
    assert segment._map.closed
    with pytest.raises(ValueError, match="released memoryview"):
        ring.read()
