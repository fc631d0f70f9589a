from onika.host.recording.last_seconds import TracedVariables
from onika.host.recording.met_variables import MetVariables
from onika.host.recording.recorded_variable import VariablePlace
from onika.ring.segment import Segment
from onika.runtime.table import HEAD, Table
from onika.words.shape import Shape

DOUBLE, INT = Shape.parse("double"), Shape.parse("int")


def place(name, shape="double", unit="", offset=HEAD):
    return VariablePlace(name, shape, unit, offset)


def test_what_has_come_is_told_once_with_its_unit():  # R-X05
    table = Table(Segment.create("test", 1 << 18))
    met = MetVariables("s0", table)
    assert met.news({}) is None
    table.entry("X", DOUBLE)
    assert met.news({"X": "m"}) == TracedVariables("s0", (place("X", unit="m"),))
    assert met.news({"X": "m"}) is None
    assert met.memory is table.segment


def test_what_is_gone_is_told_before_what_lies_there_now():  # R-X05, R-C12
    table = Table(Segment.create("test", 1 << 18))
    met = MetVariables("s0", table)
    table.entry("X", DOUBLE)
    met.news({})
    table.free(table.drop("X"))
    table.entry("N", INT)
    assert met.news({}) == TracedVariables("s0", (place("N", "int"),), ("X",))


def test_a_variable_that_is_made_anew_is_gone_and_has_come():  # R-X05
    table = Table(Segment.create("test", 1 << 18))
    met = MetVariables("s0", table)
    former = table.entry("X", DOUBLE)
    met.news({})
    table.free(table.drop("X"))
    table.entry("X", INT)
    assert met.news({}) == TracedVariables("s0", (place("X", "int"),), ("X",))
    table.free(table.drop("X"))
    table.put_back(former)
    assert met.news({}) == TracedVariables("s0", (place("X"),), ("X",))
