"""The sheet of a class, and its task files."""

import dataclasses

import msgspec
import pytest

from onika.model.task import LocalLine, Task
from onika.module import InBoth, InConst, Input, InVar, Local, Module, OutBoth, OutConst, OutVar
from onika.runtime.modules.sheet import (
    SLOWEST_HARDWARE_HZ,
    InputSheet,
    LocalSheet,
    ModuleSheet,
    PortSheet,
    differences,
    sheet_of,
)
from onika.words.fault import Place

PLACE = Place("lab/m.rmod")


class Everything(Module):
    """Has one of each."""

    hardware = True
    crit = 3
    NDOF = InConst("int", "-", "joints")
    X0 = InBoth("double", "m", "start")
    Q = InVar("double[NDOF]", "rad", "measured")
    KIND = OutConst("string", "-", "kind")
    Y0 = OutBoth("double", "m", "first")
    Qd = OutVar("double[NDOF]", "rad/s", "speed", name="Q^")
    goal = Input("double[NDOF]", "rad", "where", low=-1, high="NDOF", default=(0.0, 1.0))
    GAIN = Local("double", "-", "gain")
    LABEL = Local("line", "-", "label", default="none")
    SHARE = Local("double[2]", "-", "share", default=(0.5, 1.0), low=0.5, high=1.0)


TASK = Task(
    name="m",
    module="everything",
    inconst=("NDOF", "X0"),
    outconst=("KIND", "Y0"),
    invar=("X0", "Q"),
    outvar=("Y0", "Q^"),
    frequency=100.0,
    local=(LocalLine("GAIN", ("2",)), LocalLine("DEVICE", ("w:arm",))),
)


def test_a_sheet_says_everything_the_class_declares():  # law 24
    assert sheet_of(Everything) == ModuleSheet(
        ports=(
            PortSheet("INCONST", "NDOF", "int", "-", "joints"),
            PortSheet("INBOTH", "X0", "double", "m", "start"),
            PortSheet("INVAR", "Q", "double[NDOF]", "rad", "measured"),
            PortSheet("OUTCONST", "KIND", "string", "-", "kind"),
            PortSheet("OUTBOTH", "Y0", "double", "m", "first"),
            PortSheet("OUTVAR", "Q^", "double[NDOF]", "rad/s", "speed"),
        ),
        inputs=(InputSheet("goal", "double[NDOF]", "rad", "where", -1, "NDOF", [0.0, 1.0]),),
        locals=(
            LocalSheet("GAIN", "double", "-", "gain", None),
            LocalSheet("LABEL", "line", "-", "label", "none"),
            LocalSheet("SHARE", "double[2]", "-", "share", [0.5, 1.0], 0.5, 1.0),
        ),
        trigger=False,
        passive=False,
        hardware=True,
        crit=3,
        doc="Has one of each.",
    )


def test_a_sheet_travels():  # law 24
    sheet = sheet_of(Everything)
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(sheet), type=ModuleSheet) == sheet


def test_a_subclass_keeps_what_it_inherits():
    class More(Everything):
        Z = OutVar("int")

    names = [port.name for port in sheet_of(More).ports]
    assert names == [*(port.name for port in sheet_of(Everything).ports), "Z"]


def test_a_passive_trigger_is_refused():  # R-A08
    cls = type("Both", (Module,), {"trigger": True, "passive": True})
    with pytest.raises(ValueError, match="a passive task is never a trigger"):
        sheet_of(cls)


def test_two_ports_of_one_name_are_refused():
    cls = type("Twice", (Module,), {"A": InVar("int"), "B": OutVar("int", name="A")})
    with pytest.raises(ValueError, match="expected each port name once, found A, A"):
        sheet_of(cls)


@pytest.mark.parametrize("bound", ["NOWHERE", "Q"])
def test_a_bound_that_is_no_constant_is_refused(bound):  # law 25
    ports = {"Q": InVar("double"), "goal": Input("double", low=bound)}
    with pytest.raises(
        ValueError, match=f"input goal: expected a bound that is a number or an INCONST, found '{bound}'"
    ):
        sheet_of(type("Bound", (Module,), ports))


def faults(**changes):
    return differences(dataclasses.replace(TASK, **changes), sheet_of(Everything), PLACE)


def test_a_task_file_that_fits_has_no_fault():
    assert faults() == []


@pytest.mark.parametrize(
    ("changes", "expected", "declared"),
    [
        ({"outvar": ("Y0",)}, "OUTVAR Q^, as module everything declares", "no such port"),
        ({"invar": ("Q",)}, "INBOTH X0, as module everything declares", "INCONST"),
        ({"outconst": ("KIND",)}, "OUTBOTH Y0, as module everything declares", "OUTVAR"),
        ({"invar": ("X0", "Q", "EXTRA")}, "only ports that module everything declares", "INVAR EXTRA"),
        ({"local": TASK.local[1:]}, "a LOCAL line GAIN double (gain)", "none"),
        ({"local": TASK.local[:1]}, "a LOCAL line DEVICE world:device, as the module is hardware", "none"),
        (
            {"local": (TASK.local[0], LocalLine("DEVICE", ()))},
            "one device after LOCAL DEVICE, as world:device",
            "none",
        ),
        (
            {"local": (TASK.local[0], LocalLine("DEVICE", ("w:arm", "w:hand")))},
            "one device after LOCAL DEVICE, as world:device",
            "w:arm w:hand",
        ),
        (
            {"local": (*TASK.local, LocalLine("SHARE", ("0.5", "1.01")))},
            "LOCAL SHARE double[2]",
            "LOCAL SHARE: expected 0.5..1 -, found 1.01",
        ),
        ({"frequency": 39.9}, f"a hardware task of at least {SLOWEST_HARDWARE_HZ:g} Hz", "39.9 Hz"),
    ],
)
def test_a_difference_is_a_fault_that_names_it(changes, expected, declared):  # R-A01, law 17
    (fault,) = faults(**changes)
    assert (fault.place, str(fault.reason)) == (PLACE, f"expected {expected}, found {declared}")
    assert str(fault.instead) == "task m is left out"


def test_all_differences_are_found_at_once():  # R-E01
    assert len(faults(invar=("EXTRA",), outvar=(), local=(), frequency=10.0)) == 8


def test_lines_that_the_class_does_not_know_are_left_alone():  # R-B01
    assert faults(local=(*TASK.local, LocalLine("COMMENT", ("anything",)))) == []
