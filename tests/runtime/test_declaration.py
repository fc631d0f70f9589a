"""What a module's class declares."""

import numpy as np
import pytest

from onika.model.port import PortKind
from onika.runtime.declaration import (
    InBoth,
    InConst,
    Input,
    InVar,
    Local,
    OutBoth,
    OutConst,
    OutVar,
    memory_slot,
    slot,
)
from onika.runtime.modules.module import Module
from onika.words.shape import Shape

SHAPES = [
    "double",
    "double[3]",
    "int",
    "short[2,2]",
    "long",
    "float",
    "byte[4]",
    "char",
    "char[3]",
    "string",
    "line[2]",
]
VALUES = [0.5, [1.0, 2.0, 3.0], -7, [[1, 2], [3, 4]], 2**40, 0.25, [0, 1, 254, 255], "é", ["a", "b", "c"], "lamp on"]
VALUES.append(["two words", "ü"])


def instance(declaration, text):
    """An instance with one port X and its buffer, as the binding makes it."""
    cls = type("One", (Module,), {"X": declaration})
    owner, shape = cls(), Shape.parse(text)
    flat = np.zeros(shape.count * (shape.type.size if shape.type.is_text else 1), dtype=shape.type.code)
    shown = flat if shape.type.is_text or not shape.dims else flat.reshape(shape.dims)
    setattr(owner, slot("X"), shown)
    setattr(owner, memory_slot("X"), shown.data)
    return owner


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        (InConst, PortKind.INCONST), (OutConst, PortKind.OUTCONST), (InVar, PortKind.INVAR),
        (OutVar, PortKind.OUTVAR), (InBoth, PortKind.INBOTH), (OutBoth, PortKind.OUTBOTH),
    ],
)  # fmt: skip
def test_a_declaration_is_a_port_of_its_kind(kind, expected):  # R-A02
    port = kind("double[NDOF]", "rad", "measured").port("Q_MEZ")
    assert (port.kind, port.name, port.unit, port.meaning) == (expected, "Q_MEZ", "rad", "measured")
    assert port.shape == Shape.parse("double[NDOF]")


def test_a_coded_name_that_is_no_python_name_is_given_apart():  # law 8
    assert OutVar("double", name="Q^_REF").port("Qd_REF").name == "Q^_REF"


@pytest.mark.parametrize("attribute", ["q_mez", "Qd_REF", "_X"])
def test_a_port_that_is_no_state_variable_is_refused(attribute):  # law 8
    with pytest.raises(ValueError, match="expected a port name of capitals"):
        InVar("double").port(attribute)


@pytest.mark.parametrize(("text", "value"), list(zip(SHAPES, VALUES, strict=True)), ids=SHAPES)
def test_an_output_of_every_type_is_written_and_read_back(text, value):  # R-A03
    owner = instance(OutVar(text), text)
    owner.X = value
    assert np.all(np.asarray(owner.X) == np.asarray(value))
    assert isinstance(owner.X, np.ndarray) == (isinstance(value, list) and not isinstance(value[0], str))


def test_a_scalar_is_a_plain_number():
    assert type(instance(InVar("double"), "double").X) is float
    assert type(instance(InVar("int"), "int").X) is int


@pytest.mark.parametrize("kind", [InConst, InVar, InBoth])
def test_an_input_is_read_and_never_written(kind):  # R-A02
    owner = instance(kind("double"), "double")
    with pytest.raises(AttributeError, match=f"X is an {kind.kind.value}: it is read, never written"):
        owner.X = 1.0


def test_a_vector_is_written_into_place_and_whole():  # R-A02
    owner = instance(OutVar("double[3]"), "double[3]")
    before = owner.X
    owner.X = 7.0
    assert before is owner.X
    assert before.tolist() == [7.0, 7.0, 7.0]


def test_a_vector_of_another_length_is_refused():
    owner = instance(OutVar("double[3]"), "double[3]")
    with pytest.raises(ValueError, match="broadcast"):
        owner.X = [1.0, 2.0]


@pytest.mark.parametrize(
    ("text", "value"), [("string", "x" * 256), ("char", "ab"), ("char", "€"), ("line[2]", ["one"])]
)
def test_letters_that_do_not_fit_are_refused_by_the_ports_name(text, value):
    owner = instance(OutVar(text), text)
    with pytest.raises(ValueError, match="X: expected"):
        owner.X = value


def test_a_shorter_text_leaves_nothing_of_a_longer_one():
    owner = instance(OutVar("string"), "string")
    owner.X = "a long text"
    owner.X = "short"
    assert owner.X == "short"


def test_inputs_and_parameters_keep_what_they_were_declared_with():  # R-A10
    wanted = Input("double[NDOF]", "rad", "where to", low="QMIN", high=3.0, default=0.0)
    assert (wanted.shape, wanted.low, wanted.high, wanted.default) == (Shape.parse("double[NDOF]"), "QMIN", 3.0, 0.0)
    parameter = Local("double", "m", "stroke", default=0.1)
    assert (parameter.shape, parameter.unit, parameter.meaning, parameter.default) == (
        Shape.parse("double"), "m", "stroke", 0.1,
    )  # fmt: skip
