"""Ports."""

import pytest

from onika.model.port import Port, PortKind
from onika.words.shape import Shape


def test_there_are_six_kinds_two_ways_by_three_times():  # R-A02
    kinds = {(kind.is_input, kind.at_init, kind.at_cycle): kind.value for kind in PortKind}
    assert kinds == {
        (True, True, False): "INCONST",
        (False, True, False): "OUTCONST",
        (True, False, True): "INVAR",
        (False, False, True): "OUTVAR",
        (True, True, True): "INBOTH",
        (False, True, True): "OUTBOTH",
    }


def test_a_port_is_a_value():
    port = Port(PortKind.INVAR, "Q_MEZ", Shape.parse("double[NDOF]"), "rad", "measured")
    assert port == Port(PortKind.INVAR, "Q_MEZ", Shape.parse("double[NDOF]"), "rad", "measured")
    with pytest.raises(AttributeError):
        port.name = "Q_REF"
