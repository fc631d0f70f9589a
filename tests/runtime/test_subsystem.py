"""The tasks that share one table."""

import msgspec
import pytest

from kit.plans.build import task
from onika.model.lifecycle import State
from onika.module import InBoth, InConst, InVar, Module, OutBoth, OutConst, OutVar
from onika.ring.segment import Segment
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import Table
from onika.runtime.wiring import wire
from onika.words.shape import Shape

Q, X = "double[NDOF]", "double[4,4]"


@pytest.fixture
def table():
    segment = Segment.create("test", 1 << 20)
    yield Table(segment)
    segment.close()


def wired(name, hardware=False, aliases=(), **ports):
    planned = msgspec.structs.replace(task(name), aliases=tuple(aliases))
    return wire(planned, sheet_of(type(name, (Module,), {"hardware": hardware, **ports})))


def arm():
    """The tasks of a robot: moves along joints and along a line that share its servo."""
    return [
        wired("jtraj", NDOF=InConst("int"), Q_MEZ=InVar(Q), Q_REF=OutVar(Q)),
        wired("ctraj", X_MEZ=InVar(X), X_REF=OutVar(X)),
        wired("invkin", NDOF=InConst("int"), X_REF=InVar(X), Q_REF=OutVar(Q)),
        wired("fwdkin", NDOF=InConst("int"), Q_MEZ=InVar(Q), X_MEZ=OutVar(X)),
        wired("servo", NDOF=InConst("int"), Q_REF=InVar(Q), Q_MEZ=InVar(Q), TAU=OutVar(Q)),
        wired("puma", hardware=True, NDOF=OutConst("int"), TAU=InVar(Q), Q_MEZ=OutVar(Q)),
    ]


def subsystem(table, tasks, constants=None):
    return RunningSubsystem("0", table, tasks, {task_.name: "control" for task_ in tasks}, constants)


def write_constant(table, name, value):
    table.entry(name, Shape.parse("int"))
    table.ring(name).write(int(value).to_bytes(4, "little"))


def test_tasks_rank_in_data_flow_order_with_hardware_as_the_source(table):  # law 1
    ranks = subsystem(table, arm()).ranks
    order = sorted(ranks, key=ranks.__getitem__)
    for before, after in [("puma", "servo"), ("jtraj", "servo"), ("ctraj", "invkin"), ("invkin", "servo")]:
        assert order.index(before) < order.index(after)


def test_a_task_waits_until_its_constants_are_written(table):  # law 10
    running = subsystem(table, arm())
    assert {name for name in running.members if not running.lacking(name)} == {"ctraj", "puma"}
    assert running.lacking("servo") == ["NDOF"]
    assert running.members["servo"].state is State.WAITING
    write_constant(table, "NDOF", 6)
    assert not any(running.lacking(name) for name in running.members)


def test_a_first_value_is_waited_for_if_somebody_supplies_one_and_only_then(table):  # reading 6
    reader = wired("a", V=InBoth("int"))
    assert subsystem(table, [reader, wired("b", V=OutVar("int"))]).lacking("a") == []
    assert subsystem(table, [reader, wired("b", V=OutBoth("int"))]).lacking("a") == ["V"]


def test_what_was_written_before_its_supplier_was_there_is_waited_for(table):  # law 10, law 12
    write_constant(table, "NDOF", 6)
    running = subsystem(table, arm())
    assert running.lacking("servo") == ["NDOF"]
    running.members["puma"].state = State.OFF
    assert running.lacking("servo") == []


def test_a_spawn_command_carries_everything_a_unit_needs(table):  # R-A03, R-A06
    write_constant(table, "NDOF", 3)
    home = subsystem(table, arm())
    order = home.spawn("servo", "source", "servo.py", 7, None)
    assert (order.subsystem, order.task, order.module, order.source, order.path) == (
        "0", "servo", "servo", "source", "servo.py",
    )  # fmt: skip
    assert (order.task_type, order.frequency, order.seed, order.rank) == ("periodic", 100.0, 7, home.ranks["servo"])
    assert [(port.port, port.shape) for port in order.ports] == [
        ("NDOF", "int"), ("Q_REF", "double[3]"), ("Q_MEZ", "double[3]"), ("TAU", "double[3]"),
    ]  # fmt: skip
    assert {port.svar: port.offset for port in order.ports} == {
        name: table.entries[name].offset for name in ("NDOF", "Q_REF", "Q_MEZ", "TAU")
    }


def test_a_supplier_whose_own_shapes_depend_on_its_constant_is_known_beforehand(table):  # law 26
    order = subsystem(table, arm(), {"NDOF": 6}).spawn("puma", "", "", 0, None)
    assert "double[6]" in {port.shape for port in order.ports}
    with pytest.raises(KeyError):
        subsystem(table, arm()).spawn("puma", "", "", 0, None)


def test_what_a_supplier_states_counts_more_than_what_was_written_before(table):  # law 12
    write_constant(table, "NDOF", 3)
    order = subsystem(table, arm(), {"NDOF": 6}).spawn("servo", "", "", 0, None)
    assert "double[6]" in {port.shape for port in order.ports}


def test_shapes_that_disagree_in_the_table_are_refused(table):  # law 7
    write_constant(table, "NDOF", 3)
    table.entry("Q_MEZ", Shape.parse("double[6]"))
    with pytest.raises(ValueError, match=r"Q_MEZ is double\[6\]"):
        subsystem(table, arm()).spawn("servo", "", "", 0, None)


def turned_on(home, *names):
    for name in names:
        home.members[name].state = State.ON
    return home


CMOVE = ("ctraj", "invkin", "fwdkin", "servo", "puma")
JMOVE = ("jtraj", "fwdkin", "servo", "puma")


def test_a_reference_that_nobody_reads_any_more_is_forgotten_when_jobs_switch(table):  # law 3
    """From a Cartesian to a joint move: X_REF stands still from now on; the joint reference goes on being followed."""
    home = turned_on(subsystem(table, arm()), *CMOVE)
    assert home.forgotten(["ctraj", "invkin"], ["jtraj"]) == ("X_MEZ", "X_REF")


def test_a_reference_that_a_task_goes_on_reading_stays_in_force(table):  # law 3, reading 45
    home = turned_on(subsystem(table, arm()), *JMOVE)
    assert home.forgotten(["jtraj"], ["jtraj"]) == ()
    assert "Q_REF" not in home.forgotten(["jtraj"], ["ctraj", "invkin"])


def test_what_was_written_while_nobody_read_it_steers_nothing_when_its_first_reader_comes(table):  # law 3
    """A trajectory that ran without its servo: its last reference lies anywhere, and the arm would jump there."""
    home = turned_on(subsystem(table, arm()), "jtraj")
    assert "Q_REF" in home.forgotten([], ["servo"])
    assert "Q_REF" not in turned_on(home, "servo").forgotten([], ["fwdkin"])


def test_what_feeds_a_hardware_task_that_comes_on_is_forgotten_back_to_its_sources(table):  # law 3
    home = subsystem(table, arm())
    assert home.forgotten([], JMOVE) == ("Q_MEZ", "Q_REF", "TAU", "X_MEZ", "X_REF")


def test_aliases_part_two_robots_of_one_kind(table):  # R-C04
    left = wired("left", aliases=[("Q_MEZ", "Q_LEFT")], Q_MEZ=OutVar("double[2]"))
    right = wired("right", Q_MEZ=OutVar("double[3]"))
    home = subsystem(table, [left, right])
    for name in ("left", "right"):
        home.spawn(name, "", "", 0, None)
    assert {name: str(entry.shape) for name, entry in table.entries.items()} == {
        "Q_LEFT": "double[2]", "Q_MEZ": "double[3]",
    }  # fmt: skip


def test_a_second_writer_of_a_variable_that_is_on_is_refused(table):  # law 9
    home = turned_on(subsystem(table, arm()), *CMOVE)
    ((name, why),) = home.clashes([], ["jtraj"])
    assert (name, str(why)) == ("jtraj", "Q_REF is written by task invkin, which is ON")


def test_a_writer_that_goes_off_in_the_same_switch_is_in_nobodys_way(table):  # law 9
    home = turned_on(subsystem(table, arm()), *CMOVE)
    assert home.clashes(["ctraj", "invkin"], ["jtraj"]) == []
    assert home.clashes([], ["invkin"]) == []


def test_a_writer_that_asks_is_in_the_way_too(table):  # law 9
    home = turned_on(subsystem(table, arm()), *CMOVE)
    home.members["invkin"].state = State.ASKING
    ((name, why),) = home.clashes([], ["jtraj"])
    assert (name, str(why)) == ("jtraj", "Q_REF is written by task invkin, which is ASKING")


def test_two_writers_that_come_on_together_are_in_each_others_way(table):  # law 9
    home = subsystem(table, arm())
    ((name, why),) = home.clashes([], ["jtraj", "invkin"])
    assert (name, str(why)) == ("invkin", "Q_REF is written by task jtraj, which comes on too")
    assert home.clashes([], ["jtraj", "jtraj"]) == []


def test_what_is_forgotten_is_no_longer_in_force_in_the_table(table):  # law 3
    write_constant(table, "N", 1)
    home = subsystem(table, [wired("a", N=OutConst("int"))])
    home.forget(["N", "UNKNOWN"])
    assert table.ring("N").mark == table.ring("N").count == 1
