from dataclasses import replace
from pathlib import Path

import pytest

from onika.files import conf, onk, rmod
from onika.files.rmod import RmodText
from onika.model.application import AppFlow, Application, Icon
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax
from onika.model.task import Task, TaskType
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import OpenedText
from onika.words.fault import Refusal
from onika.words.reason import Reason

SYNTAX = Syntax((IconType("Complete job", 0, 0),), ())
TASK = Task("pid", "pid", invar=("Q_REF",), outvar=("TAU",), frequency=100.0)
ONIKON = Onikon("hold", "Complete job", "", (), blank())
CONFIGURATION = Configuration("hold", (Placed("pid"),))
APPLICATION = Application("work", False, (AppFlow((Icon(ONIKON),)),))


@pytest.fixture
def base(tmp_path: Path) -> BaseDirectory:
    return BaseDirectory(tmp_path)


def test_what_is_saved_is_listed_and_read(base: BaseDirectory) -> None:
    base.save_task(RmodText(TASK))  # R-B08
    base.save_configuration(CONFIGURATION)
    base.save_onikon(ONIKON)
    base.save_application(APPLICATION)
    assert (base.tasks, base.configurations, base.onikons, base.applications) == (
        ("pid",),
        ("hold",),
        ("hold",),
        ("work",),
    )
    record, faults = base.task("pid")
    assert record
    assert (record.task, faults) == (TASK, ())
    assert base.configuration("hold") == (CONFIGURATION, ())
    assert base.onikon("hold", SYNTAX) == (ONIKON, ())
    assert base.application("work", SYNTAX) == (APPLICATION, ())
    result = sorted(str(path.relative_to(base.path)) for path in base.path.rglob("*.*"))
    assert result == ["appl/work.appl", "conf/hold.conf", "dict/hold.onk", "module/pid.rmod"]


def test_an_empty_directory_holds_nothing(base: BaseDirectory) -> None:
    assert base.tasks + base.configurations + base.onikons + base.applications == ()
    assert base.misnamed == ()


def test_a_faulty_file_is_left_out_with_its_path_and_line_and_the_next_is_read(base: BaseDirectory) -> None:
    base.save_task(RmodText(TASK))  # R-B07, R-C01
    (base.path / "module" / "bad.rmod").write_bytes(b"MODULE bad\nDESC \xff\n")
    assert base.tasks == ("bad", "pid")
    record, (fault,) = base.task("bad")
    assert record is None
    assert str(fault).startswith(f"{base.path}/module/bad.rmod:2: expected text in UTF-8")
    assert base.task("pid")[0] is not None


def test_a_missing_file_is_a_fault(base: BaseDirectory) -> None:
    record, (fault,) = base.configuration("nothing")
    assert record is None
    assert str(fault.reason) == "expected a file that can be read, found No such file or directory"


def test_files_that_are_no_names_are_reported(base: BaseDirectory) -> None:
    (base.path / "module").mkdir()
    for name in ("1st.rmod", "two words.rmod", ".hidden.rmod", "other.txt"):
        (base.path / "module" / name).touch()
    assert base.tasks == ()
    assert [fault.reason for fault in base.misnamed] == [
        Reason.of("store.name_form", stem="'1st'"),
        Reason.of("store.name_form", stem="'two words'"),
    ]


@pytest.mark.parametrize("name", ["../secret", "/etc/passwd", "", "a/b", ".x", "a\n"])
def test_no_name_leads_out_of_the_directory(base: BaseDirectory, name: str) -> None:
    for file in (base.task_file, base.configuration_file, base.onikon_file, base.application_file, base.code_file):
        with pytest.raises(ValueError, match="expected a name"):
            file(name)


def test_saving_keeps_the_comments_of_the_file(base: BaseDirectory) -> None:
    base.save_configuration(CONFIGURATION)  # R-B01, R-B07
    path = base.configuration_file("hold")
    path.write_text("# how to hold\n" + path.read_text())
    former, _ = base.open_configuration("hold")
    assert former
    saved = base.save_configuration(replace(CONFIGURATION, placed=(Placed("pid", 3, 4),)), former)
    assert path.read_text() == "# how to hold\n" + conf.write(Configuration("hold", (Placed("pid", 3, 4),)))
    assert isinstance(saved, OpenedText)
    assert base.open_configuration("hold") == (saved, ())
    base.save_onikon(ONIKON)
    path = base.onikon_file("hold")
    path.write_text("# mine\n" + path.read_text())
    base.save_onikon(replace(ONIKON, description="x"), overwrites=True)
    assert path.read_text() == "# mine\n" + onk.write(replace(ONIKON, description="x"))


def test_what_another_changed_meanwhile_is_not_overwritten(base: BaseDirectory) -> None:
    base.save_application(APPLICATION)  # R-B07
    former, _ = base.open_application("work", SYNTAX)
    path = base.application_file("work")
    theirs = "# theirs\n" + path.read_text()
    path.write_text(theirs)
    refusal = base.save_application(APPLICATION, former)
    assert isinstance(refusal, Refusal)
    assert "has changed since it was read" in str(refusal.reason)
    assert path.read_text() == theirs
    assert isinstance(base.save_application(APPLICATION, former, overwrites=True), OpenedText)
    assert path.read_text() == theirs


def test_a_broken_application_is_opened_as_far_as_it_can_be_read(base: BaseDirectory) -> None:
    base.save_application(APPLICATION)  # R-B07
    path = base.application_file("work")
    path.write_text(path.read_text().replace("EOF", ""))
    assert base.open_application("work", SYNTAX)[0] is None
    result, faults = base.salvage_application("work", SYNTAX)
    assert result is not None
    assert (result.value, str(result.text)) == (APPLICATION, path.read_text())
    assert faults


def test_a_task_is_saved_over_the_text_it_was_read_from(base: BaseDirectory) -> None:
    record = base.save_task(RmodText(TASK))  # R-B01, R-B07
    assert isinstance(record, RmodText)
    slower = base.save_task(record, replace(TASK, frequency=50.0))
    assert isinstance(slower, RmodText)
    assert isinstance(base.save_task(record), Refusal)
    copy = base.save_task(slower, replace(TASK, name="copy"))
    assert isinstance(copy, RmodText)
    assert isinstance(base.save_task(RmodText(TASK)), Refusal)
    assert isinstance(base.save_task(RmodText(TASK), overwrites=True), RmodText)
    assert [base.task(name)[0].task.frequency for name in ("pid", "copy")] == [100.0, 100.0]  # type: ignore[union-attr]


def test_a_configuration_and_an_application_of_one_name_do_not_take_each_others_icon(base: BaseDirectory) -> None:
    base.save_configuration(CONFIGURATION)  # reading 34
    base.save_application(replace(APPLICATION, name="hold"))
    assert isinstance(base.save_onikon(ONIKON), OpenedText)
    refusal = base.save_onikon(replace(ONIKON, type="Complete application"))
    assert isinstance(refusal, Refusal)
    assert "the configuration and the application hold share it" in str(refusal.reason)
    assert refusal.remedies[0] == Reason.of("store.rename_either", name="hold")
    confirmed = base.save_onikon(replace(ONIKON, type="Complete application"), overwrites=True)
    assert isinstance(confirmed, OpenedText)
    assert base.onikon_file("hold").read_text() == str(confirmed.text)


def test_where_no_directory_can_be_the_saving_is_refused(base: BaseDirectory) -> None:
    (base.path / "conf").write_text("a file")  # R-B07
    refusal = base.save_configuration(CONFIGURATION)
    assert isinstance(refusal, Refusal)
    assert "cannot be saved" in str(refusal.reason)


def test_a_module_lies_beside_its_tasks(base: BaseDirectory) -> None:
    assert base.code_file("pid") == base.path / "module" / "pid.py"
    assert base.task_file("pid").suffix == rmod.ENDING
    assert TaskType.PERIODIC is TASK.type


def test_puzzles_are_listed_and_read(base: BaseDirectory) -> None:
    assert base.puzzles == ()  # R-G10
    file = base.puzzle_file("light")
    file.parent.mkdir()
    file.write_text("VERSION 2.0\nTITLE en A\nTASK en B\nLEVEL 1\nEXPECT LAMP == 1\nEOF\n")
    (file.parent / "light.al").write_text("")
    puzzle, faults = base.puzzle("light")
    assert base.puzzles == ("light",) and faults == ()
    assert puzzle is not None and puzzle.expectations == ("LAMP == 1",)
