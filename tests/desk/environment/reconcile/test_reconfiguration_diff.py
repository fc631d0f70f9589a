from dataclasses import replace

import pytest

from onika.desk.environment.reconcile.reconfiguration_diff import Reconfiguration, reconfiguration, with_facts
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.live import SubsystemFacts, TaskFacts
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Group, Placed
from onika.model.task import LocalLine, Task, TaskType
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries
from onika.wire import live

TASKS = (
    Task("source", "source", outvar=("X",), frequency=10.0),
    Task("filter", "filter", invar=("X",), outvar=("Y",), frequency=10.0),
    Task("arm", "arm", invar=("Y",), frequency=100.0, local=(LocalLine("DEVICE", ("boxes:arm",)),)),
    Task("once", "once", invar=("Y",), type=TaskType.APERIODIC),
)
UNITS = ("rt0", "rt1")


@pytest.fixture
def libraries(tmp_path):
    base = BaseDirectory(tmp_path)
    for task in TASKS:
        base.save_task(RmodText(task))
        (tmp_path / "module" / f"{task.module}.py").write_text(f"# {task.module}\n")
    return OpenLibraries(open_libraries([base]))


def content(wanted, **changed):
    placed = [Placed(name, **changed.get(name, {})) for name in wanted]
    return Content(Configuration("c", tuple(placed)), wanted)


def living(*states, **more):
    return SubsystemFacts("main", "live", {name: TaskFacts(state, rtpu="rt0") for name, state in states}, **more)


def test_what_is_placed_is_spawned_off_and_what_is_removed_is_killed(libraries):  # R-C11
    what = reconfiguration(
        content({"arm": True}), content({"source": False}), living(("arm", "ON")), libraries, (), UNITS
    )
    assert (what.kill, [task.task.name for task in what.spawn], what.on, what.off) == (("arm",), ["source"], (), ())
    change = what.change("main")
    assert isinstance(change, live.Change) and [code.module for code in change.code] == ["source"]
    assert what.names == {"arm", "source"} and what.wakes


def test_nothing_comes_of_what_stays_as_it_was(libraries):
    same = content({"source": True, "filter": False})
    what = reconfiguration(same, same, living(("source", "ON"), ("filter", "OFF")), libraries, (), UNITS)
    assert what.is_nothing and what == Reconfiguration() and not what.wakes


def test_producers_come_on_before_their_consumers(libraries):  # law 1
    names = ("filter", "source", "arm")
    off, on = dict.fromkeys(names, False), dict.fromkeys(names, True)
    lives = living(*((name, "OFF") for name in names))
    what = reconfiguration(content(off), content(on), lives, libraries, (), UNITS)
    assert [task.task for task in what.on] == ["source", "filter", "arm"]


def test_an_argument_line_goes_with_the_task_it_is_for(libraries):
    lives = living(("once", "OFF"), turns={"once": "1 2"})
    what = reconfiguration(content({"once": False}), content({"once": True}), lives, libraries, (), UNITS)
    assert what.on == (live.Turn("once", "1 2"),)


def test_a_task_that_is_wanted_already_is_turned_on_where_that_is_asked_for(libraries):  # R-C11
    same = content({"source": True})
    assert reconfiguration(same, same, living(("source", "ERROR")), libraries, (), UNITS).is_nothing
    lives = living(("source", "ERROR"), turns={"source": ""})
    assert reconfiguration(same, same, lives, libraries, (), UNITS).on == (live.Turn("source"),)


def test_a_rate_changes_in_place_and_no_rate_is_given_to_who_has_none(libraries):  # R-C11
    names = {"source": True, "once": False}
    lives = living(("source", "ON"), ("once", "OFF"))
    after = content(names, source={"frequency": 25.0}, once={"frequency": 25.0})
    assert reconfiguration(content(names), after, lives, libraries, (), UNITS).rates == (("source", 25.0),)
    back = reconfiguration(after, content(names), lives, libraries, (), UNITS)
    assert back.rates == (("source", 10.0),)


def test_who_is_not_born_yet_gets_another_rate_by_being_exchanged(libraries):  # law 10
    names = {"source": False}
    after = content(names, source={"frequency": 25.0})
    what = reconfiguration(content(names), after, living(("source", "WAITING")), libraries, (), UNITS)
    assert what.kill == ("source",) and what.spawn[0].task.frequency == 25.0 and what.rates == ()


def test_who_is_on_already_is_not_asked_to_come_on(libraries):
    off, on = content({"source": False}), content({"source": True})
    assert reconfiguration(off, on, living(("source", "ON")), libraries, (), UNITS).is_nothing


def test_another_unit_or_a_changed_description_means_an_exchange(libraries):  # R-C04, reading 9
    names = {"source": True, "filter": False}
    lives = living(("source", "ON"), ("filter", "OFF"))
    moved = reconfiguration(content(names), content(names, source={"rtpu": "rt1"}), lives, libraries, (), UNITS)
    assert moved.kill == ("source",) and moved.spawn[0].task.rtpu == "rt1" and moved.on == (live.Turn("source"),)
    edited = reconfiguration(content(names), content(names), lives, libraries, ("filter",), UNITS)
    assert (edited.kill, edited.on) == (("filter",), ())


@pytest.mark.parametrize("rtpu", ["rt0", "unknown", "elsewhere"])
def test_the_unit_it_lives_on_or_one_that_is_not_there_moves_nobody(libraries, rtpu):  # reading 12
    names = {"source": True}
    after = content(names, source={"rtpu": rtpu})
    assert reconfiguration(content(names), after, living(("source", "ON")), libraries, (), UNITS).is_nothing


def test_hardware_that_is_exchanged_stays_off_until_somebody_turns_it_on(libraries):  # law 12, law 22
    names = {"arm": True}
    what = reconfiguration(content(names), content(names), living(("arm", "ON")), libraries, ("arm",), UNITS)
    assert what.kill == ("arm",) and what.on == () and what.resting == ("arm",)


def test_a_placed_task_that_does_not_live_is_born_when_it_is_turned_on(libraries):
    what = reconfiguration(content({"source": False}), content({"source": True}), living(), libraries, (), UNITS)
    assert what.kill == () and what.spawn[0].task.name == "source" and what.on == (live.Turn("source"),)


def test_who_has_no_code_is_a_fault_and_who_is_missing_is_left_out(libraries, tmp_path):  # R-C01, reading 11
    (tmp_path / "module" / "source.py").unlink()
    after = content({"source": False, "stranger": False})
    what = reconfiguration(content({}), after, living(), libraries, (), UNITS)
    reasons = [(fault.key, fault.args["task"], fault.args["why"].key) for fault in what.faults]
    assert reasons == [("run.cannot_live", "source", "run.code_missing")]
    assert what.is_nothing


def test_who_is_to_be_born_is_shown_so_at_once_on_its_unit(libraries):  # R-C11
    after = content({"source": False, "filter": False}, filter={"rtpu": "rt1"})
    what = reconfiguration(content({}), after, living(turns={"source": ""}), libraries, (), UNITS)
    lives = with_facts(living(turns={"source": ""}), what, UNITS)
    assert lives.tasks["source"] == TaskFacts("SPAWNING", rtpu="rt0", hz=10.0)
    assert lives.tasks["filter"].rtpu == "rt1" and lives.turns == {}


def test_a_supermodule_is_spawned_and_turned_on_in_its_order_and_off_the_other_way_round(libraries):  # R-C17
    def grouped(wanted):
        plain = content(wanted)
        group = Group("arm", ("arm", "source"))
        return Content(replace(plain.configuration, groups=(group,)), plain.wanted)

    names = ("source", "filter", "arm")
    off, on = grouped(dict.fromkeys(names, False)), grouped(dict.fromkeys(names, True))
    lives = living(*((name, "OFF") for name in names))
    assert [task.task for task in reconfiguration(off, on, lives, libraries, (), UNITS).on] == [
        "arm",
        "filter",
        "source",
    ]
    moving = living(*((name, "ON") for name in names))
    assert reconfiguration(on, off, moving, libraries, (), UNITS).off == ("source", "filter", "arm")
    born = reconfiguration(grouped({}), off, living(), libraries, (), UNITS).spawn
    assert [birth.task.name for birth in born] == ["arm", "filter", "source"]
