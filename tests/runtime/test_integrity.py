"""The check of a table's memory, on memory that is really overwritten."""

import ctypes

import numpy as np
import pytest
from hypothesis import given, strategies as st

from kit.labs.module_source import module
from kit.plans.build import task as planned
from kit.runtime.executive_rig import ExecutiveRig
from onika.ring.slots import LONGEST_SEALED, Ring
from onika.runtime import command
from onika.runtime.integrity import Accessor, accessor, check
from onika.runtime.wiring import wire

MS = 1_000_000


def writer(svar, shape="double[6]"):
    return module(f"    {svar} = OutVar('{shape}')\n    def cycle(self):\n        self.{svar} += 1.0")


def accessors():
    """Who is bound to what, as their configuration says."""
    return [
        Accessor("left", "rt0", frozenset({"A"}), frozenset()),
        Accessor("middle", "rt0", frozenset({"B"}), frozenset({"A"})),
        Accessor("right", "rt1", frozenset({"C"}), frozenset()),
        Accessor("far", "rt1", frozenset({"D"}), frozenset()),
    ]


@pytest.fixture
def rig():
    rig = ExecutiveRig()
    for rank, (task, svar) in enumerate((("left", "A"), ("middle", "B"), ("right", "C"), ("far", "D"))):
        rig.spawn(task, writer(svar), rank=rank)
    return rig.switch(on=["left", "middle", "right", "far"]).run(50 * MS)


def texts(reasons):
    return tuple(map(str, reasons))


def only_finding(rig, variable):
    findings = {str(finding.variable): finding for finding in check(rig.table, accessors())}
    assert set(findings) == {variable}
    return findings[variable]


def test_a_table_that_only_its_writers_write_is_sound(rig):  # R-A12
    assert check(rig.table, accessors()) == []
    rig.switch(off=["middle"]).spawn("other", writer("B")).switch(on=["other"]).run(100 * MS)
    rig.switch(off=["other"], on=["middle"]).run(150 * MS)
    assert check(rig.table, accessors()) == []


def address_of(rig, svar):
    """Where an entry lies in this process."""
    view = rig.table.segment.view
    return ctypes.addressof(ctypes.c_char.from_buffer(view)) + rig.table.entries[svar].offset


def test_a_module_that_writes_past_its_entry_is_named_as_a_candidate(rig):  # R-A12
    """`left` takes the address of its own entry and writes 8 bytes too many behind its last slot."""
    last_slot = address_of(rig, "A") + Ring.footprint(48) - 8
    ctypes.memset(last_slot, 0x5A, 16)
    findings = {finding.variable: finding for finding in check(rig.table, accessors())}
    assert texts(findings["B"].wrong) == ("its guard is overwritten",)
    assert "task left on rt0 (is bound to A beside it)" in texts(findings["B"].likely)
    assert "task middle on rt0 (writes it)" in texts(findings["B"].likely)
    assert texts(findings["B"].others) == ("task far on rt1",)
    assert texts(findings["A"].wrong) == ("the memory between its slots is overwritten",)


def test_a_value_written_over_in_place_is_found_until_it_is_made_anew(rig):  # R-A12
    rig.run(70 * MS)  # to a publication that is sealed
    ring = rig.table.ring("C")
    ctypes.memset(address_of(rig, "C") + 64 + (ring.count & 63) * 64 + 8, 0x11, 4)
    finding = only_finding(rig, "C")
    assert texts(finding.wrong) == ("its value is not what its writer published",)
    assert str(finding.reason).startswith("C: its value is not what its writer published. It could have been task ")
    assert "task far on rt1 (is bound to D beside it)" in texts(finding.likely)
    assert texts(finding.others) == ("task left on rt0",)
    rig.run(100 * MS)
    assert check(rig.table, accessors()) == []


def test_somebody_who_publishes_a_foreign_variable_leaves_a_trace_for_good(rig):  # R-A12
    """`far` writes D and, through a ring of its own, B: a value that looks whole."""
    ring = Ring(rig.table.segment.view, rig.table.entries["B"].offset, 48)
    ring.signed_writer(memoryview(np.full(6, 9.0)).cast("B")).publish()
    rig.run(200 * MS)
    finding = only_finding(rig, "B")
    assert texts(finding.wrong) == ("it was published 1 time by somebody who is not its writer",)
    assert "task far on rt1" in texts(finding.others)


def test_a_module_that_does_it_in_its_own_cycle_is_named(rig):  # R-A12
    """It reaches the table through the frame that called it, and publishes B as if it were its own."""
    source = module(
        "    D2 = OutVar('double')\n    AT = Local('int')\n    def cycle(self):\n"
        "        table = sys._getframe(1).f_locals['self']._views['table:rig']\n"
        "        Ring(table, self.AT, 48).write(bytes(48))"
    )
    source = "from onika.ring.slots import Ring\n" + source
    rig.spawn("bad", source, local=[("AT", (str(rig.table.entries["B"].offset),))], rank=9)
    rig.switch(on=[command.Launch("bad")]).run(60 * MS)
    rig.switch(off=["bad"])
    findings = check(rig.table, [*accessors(), Accessor("bad", "rt0", frozenset({"D2"}), frozenset())])
    assert [finding.variable for finding in findings] == ["B"]
    assert "published 1 time by somebody who is not its writer" in str(findings[0].reason)
    assert "task bad on rt0" in texts(findings[0].others)
    rig.run(200 * MS)
    assert [finding.variable for finding in check(rig.table, [])] == ["B"]  # for good


def test_free_memory_that_is_written_is_found(rig):  # R-A12
    ctypes.memset(address_of(rig, "A") + rig.table.end + 100, 1, 1)
    finding = only_finding(rig, "free memory")
    assert texts(finding.wrong) == ("memory behind D, which belongs to no variable, is written",)
    assert texts(finding.likely) == ("task far on rt1 (is bound to D beside it)",)


def test_a_long_value_is_sealed_while_its_writer_rests():  # R-A12
    rig = (
        ExecutiveRig().spawn("camera", writer("IMAGE", f"double[{LONGEST_SEALED}]")).switch(on=["camera"]).run(30 * MS)
    )
    assert check(rig.table, []) == []
    rig.switch(off=["camera"])
    ring = rig.table.ring("IMAGE")
    ctypes.memset(address_of(rig, "IMAGE") + 64 + (ring.count & 3) * LONGEST_SEALED * 8 + 2000, 0x33, 1)
    assert [finding.variable for finding in check(rig.table, [])] == ["IMAGE"]


def test_a_constant_that_is_overwritten_is_found_as_long_as_it_stands():  # R-A12
    source = module("    QMAX = OutConst('double[2]')\n    def init(self):\n        self.QMAX = (1.0, 2.0)")
    rig = ExecutiveRig().spawn("robot", source)
    assert check(rig.table, []) == []
    ring = rig.table.ring("QMAX")
    ctypes.memset(address_of(rig, "QMAX") + 64 + (ring.count & 63) * 64, 0xFF, 1)
    assert [finding.variable for finding in check(rig.table, [])] == ["QMAX"]


@pytest.mark.parametrize("count", [*range(6), *range(7, 40), 2**31 + 6, 2**40])
def test_a_counter_that_is_moved_at_rest_is_found(count):  # R-A12
    rig = ExecutiveRig().spawn("left", writer("A"))
    rig.switch(on=["left"]).run(50 * MS).switch(off=["left"])
    assert rig.table.ring("A").count == 6
    rig.table.ring("A").words[0] = count
    (finding,) = check(rig.table, [])
    assert "its counter was" in str(finding.reason)


@given(st.integers(0, 4 * (64 + 64 * 64) - 1), st.binary(min_size=1, max_size=40))
def test_whatever_is_written_astray_is_found_or_harms_no_value(place, data):  # R-A12
    """Bytes anywhere in a table at rest: either the check tells, or every variable still has its value."""
    rig = ExecutiveRig()
    for task, svar in (("left", "A"), ("middle", "B"), ("right", "C"), ("far", "D")):
        rig.spawn(task, writer(svar))
    everyone = ["left", "middle", "right", "far"]
    rig.switch(on=everyone).run(50 * MS).switch(off=everyone)
    values = {svar: rig[svar].tolist() for svar in "ABCD"}
    rig.table.segment.view[place : place + len(data)] = data
    findings = check(rig.table, accessors())
    after = {svar: rig[svar].tolist() for svar in "ABCD"}
    assert findings or after == values


def test_what_a_task_is_bound_to_is_read_off_its_wires():  # R-A12
    from onika.wire.sheet import ModuleSheet, PortSheet

    ports = tuple(
        PortSheet(kind, name, "int", "-", "") for kind, name in (("INCONST", "A"), ("INBOTH", "B"), ("OUTVAR", "C"))
    )
    wired = wire(planned("t"), ModuleSheet(ports, (), (), False, False, False, 0, ""))
    assert accessor(wired, "rt1") == Accessor("t", "rt1", frozenset({"C"}), frozenset({"A", "B"}))
