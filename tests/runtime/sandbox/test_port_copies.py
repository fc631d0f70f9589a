from itertools import pairwise

import numpy as np
import pytest

from kit.runtime.executive_rig import ExecutiveRig
from onika.runtime.modules.binding import Binding, instantiate
from onika.runtime.modules.code import load
from onika.runtime.sandbox.port_copies import PortCopies, put, take
from onika.runtime.sandbox.sandbox_messages import places_of

SOURCE = """
from onika.module import InConst, InVar, Module, OutVar

class Ports(Module):
    C = InConst("int", "-", "a constant")
    X = InVar("double[3]", "-", "read")
    Y = OutVar("double[2]", "-", "written")
"""


def bound():
    rig = ExecutiveRig()
    spawn = rig.spawn_of("ports", SOURCE)
    instance = instantiate(load(SOURCE, "ports.py", "ports"), spawn, rig.views)
    return instance, Binding(instance, spawn, rig.views)


def places(binding):
    return places_of(((name, shape) for name, shape, _ in binding.values), None)


def test_values_go_over_and_come_back():  # R-X16
    instance, binding = bound()
    memory = np.zeros(4096, np.uint8)
    copies = PortCopies(binding, instance.declared_ports, places(binding), memory)
    assert [len(some) for some in (copies.every, copies.inputs, copies.outputs)] == [3, 1, 1]
    instance.Y = [1.5, 2.5]
    put(copies.outputs)
    instance.Y = [0.0, 0.0]
    take(copies.outputs)
    assert instance.Y.tolist() == [1.5, 2.5]


def test_ports_lie_apart_each_at_a_line_of_its_own():
    _, binding = bound()
    spans = [(place.offset, place.offset + place.size) for place in places(binding)]
    assert all(begin % 64 == 0 for begin, _ in spans)
    assert all(end <= begin for (_, end), (begin, _) in pairwise(spans))


def test_memory_without_room_is_refused():
    instance, binding = bound()
    with pytest.raises(ValueError, match="no room for Y"):
        PortCopies(binding, instance.declared_ports, places(binding), np.zeros(190, np.uint8))
