"""How tasks meet in their variables."""

import msgspec

from kit.plans.build import task
from onika.module import InBoth, InConst, InVar, Module, OutBoth, OutConst, OutVar
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.wiring import disagreements, missing_constants, upstream, wire
from onika.words.shape import Shape


def wired(name, aliases=(), **ports):
    """A task whose class declares these ports."""
    planned = msgspec.structs.replace(task(name), aliases=tuple(aliases))
    return wire(planned, sheet_of(type(name, (Module,), ports)))


def test_ports_are_bound_by_their_aliases_once():  # R-C04
    wired_task = wired("one", [("A", "B"), ("B", "A")], A=InVar("int"), B=OutVar("int"), C=InConst("int"))
    assert [(port.port, port.svar) for port in wired_task.ports] == [("A", "B"), ("B", "A"), ("C", "C")]


def test_the_dimensions_of_a_shape_are_aliased_too():  # R-A03
    wired_task = wired("one", [("NDOF", "NDOF_LEFT")], Q=InVar("double[NDOF,4]"))
    assert wired_task.ports[0].shape == Shape.parse("double[NDOF_LEFT,4]")


def test_variables_stand_in_the_lists_of_their_kinds():  # reading 7
    wired_task = wired(
        "one", A=InConst("int"), B=InBoth("int"), C=InVar("int"), D=OutConst("int"), E=OutBoth("int"), F=OutVar("int")
    )
    assert (wired_task.inconst, wired_task.invar, wired_task.outconst, wired_task.outvar) == (
        ("A", "B"),
        ("B", "C"),
        ("D", "E"),
        ("E", "F"),
    )
    assert wired_task.first_values == ("B",)
    assert (wired_task.meeting.name, wired_task.meeting.inconst, wired_task.meeting.outvar) == (
        "one",
        ("A", "B"),
        ("E", "F"),
    )


def test_the_device_is_the_first_word_of_its_local_line():  # law 16
    planned = msgspec.structs.replace(task("one"), local=(("GAIN", ("2",)), ("DEVICE", ("boxes:arm", "rest"))))
    assert wire(planned, sheet_of(Module)).device == "boxes:arm"
    assert wire(task("one"), sheet_of(Module)).device is None


def test_tasks_that_declare_a_variable_alike_agree():  # law 7
    tasks = [wired("a", X=OutVar("double[NDOF]", "m")), wired("b", X=InVar("double[NDOF]", "m"))]
    assert disagreements(tasks) == []


def test_another_type_shape_or_unit_is_a_fault_that_names_both_tasks():  # law 7
    first = wired("a", X=OutVar("double[NDOF]", "m"))
    others = [wired("b", X=InVar("float[NDOF]", "m")), wired("c", X=InVar("double[6]", "m"))]
    others.append(wired("d", X=InVar("double[NDOF]", "mm")))
    faults = disagreements([first, *others])
    expected = "expected X double[NDOF] in m, as a declares"
    assert [(fault.place.file, str(fault.reason)) for fault in faults] == [
        ("b.rmod", f"{expected}, found float[NDOF] in m"),
        ("c.rmod", f"{expected}, found double[6] in m"),
        ("d.rmod", f"{expected}, found double[NDOF] in mm"),
    ]


def test_tasks_that_do_not_meet_cannot_disagree():
    assert disagreements([wired("a", [("X", "Y")], X=OutVar("int")), wired("b", X=InVar("double"))]) == []


def test_a_constant_that_nobody_supplies_is_a_fault():  # law 10, reading 6
    tasks = [wired("a", N=InConst("int"), M=InConst("int")), wired("b", M=OutConst("int")), wired("c", N=OutVar("int"))]
    assert [(fault.place.file, str(fault.reason)) for fault in missing_constants(tasks)] == [
        ("a.rmod", "expected a task that supplies the constant N, found none")
    ]


def test_an_inboth_takes_any_output_but_needs_one():  # reading 6
    reader = wired("a", X=InBoth("int"))
    assert missing_constants([reader, wired("b", X=OutVar("int"))]) == []
    assert missing_constants([reader, wired("b", X=OutBoth("int"))]) == []
    assert len(missing_constants([reader])) == 1


def test_upstream_is_everything_from_which_a_variable_is_made():  # law 3
    tasks = [
        wired("traj", OUT=OutVar("int"), SEEN=InVar("int")),
        wired("mid", OUT=InVar("int"), NEXT=OutVar("int")),
        wired("servo", NEXT=InVar("int"), TAU=OutVar("int")),
        wired("apart", Z=OutVar("int"), W=InVar("int")),
    ]
    assert upstream(tasks, ["TAU"]) == {"TAU", "NEXT", "OUT", "SEEN"}
    assert upstream(tasks, []) == frozenset()


def test_upstream_of_a_loop_comes_to_an_end():
    tasks = [wired("a", X=InVar("int"), Y=OutVar("int")), wired("b", Y=InVar("int"), X=OutVar("int"))]
    assert upstream(tasks, ["X"]) == {"X", "Y"}


def test_what_shapes_a_task_counts_as_a_constant_that_it_reads_when_tasks_are_exchanged():  # R-A13, law 12
    wired_task = wired(
        "one", [("NDOF", "NDOF_LEFT")], N=OutConst("int"), Q=InVar("double[NDOF,N]"), GAIN=InBoth("double")
    )
    assert wired_task.placed.ports.inconst == ("GAIN", "NDOF_LEFT")
    assert (wired_task.placed.name, wired_task.placed.module, wired_task.placed.device) == (
        "one",
        wired_task.task.module,
        None,
    )
