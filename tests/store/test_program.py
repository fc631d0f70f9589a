from pathlib import Path

import pytest

from onika.files.rmod import RmodText
from onika.model.application import AppFlow, Application, Branch, Icon
from onika.model.configuration import Configuration, Group, Placed
from onika.model.onikon import Onikon
from onika.model.own_lines import OwnLines
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax
from onika.model.task import LocalLine, Task
from onika.store.base_directory import BaseDirectory
from onika.store.program import load
from onika.store.site import Site

SYNTAX = Syntax(tuple(IconType(name, 0, 0) for name in ("Complete job", "Complete application", "Complete NOP")), ())


def application(name: str, *icons: tuple[str, str]) -> Application:
    placed = [Icon(Onikon(icon, f"Complete {kind}", "", (), blank())) for icon, kind in icons]
    return Application(name, False, (AppFlow(tuple(placed)),))


@pytest.fixture
def bases(tmp_path: Path) -> tuple[BaseDirectory, BaseDirectory]:
    return BaseDirectory(tmp_path / "own"), BaseDirectory(tmp_path / "shared")


@pytest.fixture
def site(bases: tuple[BaseDirectory, BaseDirectory], tmp_path: Path) -> Site:
    return Site(bases[1:], tmp_path / "prefs")


def test_what_an_application_needs_is_gathered_its_own_base_first(
    site: Site, bases: tuple[BaseDirectory, BaseDirectory]
) -> None:
    own, shared = bases  # reading 35
    work = application("work", ("hold", "job"), ("part", "application"), ("wait", "NOP"), ("hold", "job"))
    own.save_application(work)
    part = application("part", ("grip", "job"), ("part", "application"))
    shared.save_application(part)
    shared.save_configuration(Configuration("hold", (Placed("lost"),)))
    own.save_configuration(Configuration("hold", (Placed("pid"), Placed("lost"))))
    shared.save_configuration(Configuration("grip", (Placed("hand"),)))
    for name in ("pid", "hand", "unused"):
        shared.save_task(RmodText(Task(name, name, frequency=1.0)))
    shared.code_file("pid").touch()

    program, faults = load(own.application_file("work"), site, SYNTAX)
    assert faults == ()
    assert program
    assert program.application == work
    assert program.configurations == {
        "hold": Configuration("hold", (Placed("pid"), Placed("lost"))),
        "grip": Configuration("grip", (Placed("hand"),)),
    }
    assert sorted(program.tasks) == ["hand", "pid"]
    assert program.code == {"pid": shared.code_file("pid")}
    assert program.applications == {"part": part}
    assert program.files == {"part": str(shared.application_file("part"))}


def test_the_faults_of_all_files_read_are_given_and_no_others(
    site: Site, bases: tuple[BaseDirectory, BaseDirectory]
) -> None:
    own, shared = bases  # R-B07
    own.save_application(application("work", ("hold", "job"), ("grip", "job"), ("missing", "job")))
    shared.save_configuration(Configuration("hold", (Placed("pid"),)))
    for file in (shared.configuration_file("grip"), shared.task_file("pid"), shared.task_file("unused")):
        file.parent.mkdir(exist_ok=True)
        file.write_text("WRONG\nEOF")
    program, faults = load(own.application_file("work"), site, SYNTAX)
    assert program
    assert program.faults == faults
    files = {Path(fault.place.file).name for fault in faults}
    assert files == {"pid.rmod", "grip.conf"}
    assert program.tasks == {}
    assert program.unread == {"grip", "pid"}


def test_an_application_that_cannot_be_read_is_none(
    site: Site, bases: tuple[BaseDirectory, BaseDirectory], tmp_path: Path
) -> None:
    program, faults = load(tmp_path / "nothing.appl", site, SYNTAX)
    assert (program, len(faults)) == (None, 1)
    (tmp_path / "bad.appl").write_text("VERSION 1.3\n")
    program, faults = load(tmp_path / "bad.appl", site, SYNTAX)
    assert program is None
    assert faults


def test_what_branches_and_deep_nests_need_is_gathered_too(
    site: Site, bases: tuple[BaseDirectory, BaseDirectory]
) -> None:
    own, shared = bases  # R-D13, R-E06
    deep = application("deep", ("grip", "job")).flows[0]
    shared.save_application(Application("part", False, (AppFlow((Branch((AppFlow(()), deep)),)),)))
    shared.save_configuration(Configuration("grip"))
    for at in range(400):
        shared.save_application(application(f"p{at}", (f"p{at + 1}" if at < 399 else "part", "application")))
    own.save_application(application("work", ("p0", "application"), ("bad", "application")))
    shared.application_file("bad").write_text("WRONG\nEOF")
    program, _ = load(own.application_file("work"), site, SYNTAX)
    assert program
    assert len(program.applications) == 401
    assert list(program.configurations) == ["grip"]
    assert program.unread == {"bad"}


def test_a_task_is_what_its_configuration_says_of_it(site: Site, bases: tuple[BaseDirectory, BaseDirectory]) -> None:
    own, _ = bases  # R-B09, R-E01
    gain = OwnLines(local=(LocalLine("GAIN", ("2",)),))
    own.save_application(application("work", ("a", "job"), ("b", "job"), ("c", "job")))
    own.save_task(RmodText(Task("pid", "pid", frequency=1.0, local=(LocalLine("GAIN", ("1",)),))))
    own.save_configuration(Configuration("a", (Placed("pid", own=gain),), groups=(Group("g", ("pid",)),)))
    own.save_configuration(Configuration("b", (Placed("pid"),), groups=(Group("g", ("pid",)),)))
    own.save_configuration(Configuration("c", (Placed("pid", own=gain), Placed("second", rmod="pid"))))

    program, faults = load(own.application_file("work"), site, SYNTAX)
    assert faults == () and program
    assert {name: task.local[0].words for name, task in program.tasks.items()} == {
        "pid": ("2",),
        "pid-b": ("1",),
        "second": ("1",),
    }
    assert all(name == task.name for name, task in program.tasks.items())
    assert [placed.task for placed in program.configurations["b"].placed] == ["pid-b"]
    assert program.configurations["b"].groups == (Group("g", ("pid-b",)),)
    assert program.configurations["a"].placed[0].task == program.configurations["c"].placed[0].task == "pid"
    assert program.task_files == {"pid-b": "pid", "second": "pid"}
