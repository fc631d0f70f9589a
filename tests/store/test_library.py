import os
import runpy
from pathlib import Path

import pytest

from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model.task import LocalLine, Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import Library, open_libraries, open_library, reopen_libraries

BENCH = runpy.run_path(str(Path(__file__).parents[2] / "tools" / "bench" / "library.py"))
TEXT = rmod.write(RmodText(Task("t", "m", frequency=10.0)))


@pytest.fixture
def base(tmp_path: Path) -> BaseDirectory:
    (tmp_path / "module").mkdir()
    return BaseDirectory(tmp_path)


def module(base: BaseDirectory, name: str) -> Path:
    return base.path / "module" / name


def sentences(library: Library) -> list[str]:
    return [f"{Path(fault.place.file).name}: {fault.reason}" for fault in library.faults]


@pytest.mark.parametrize("count", [1_000, pytest.param(10_000, marks=pytest.mark.slow)])
def test_every_task_is_there_and_exactly_the_broken_ones_are_told(base: BaseDirectory, count: int) -> None:
    (base.path / "module").rmdir()  # R-C01, R-B07
    broken = BENCH["fill"](base.path, count)
    library = open_library(base)
    assert broken == count // 100
    assert (len(library.tasks), len(library.left_out)) == (count - broken, broken)
    assert set(library.left_out) == {
        str(base.task_file(f"task{number:05}")) for number in range(count) if number % 100 == 50
    }
    assert library.tasks["task00007"].task.frequency == 8.0


def test_a_task_that_an_earlier_library_has_is_noted_and_not_added(tmp_path: Path) -> None:
    item, two = BaseDirectory(tmp_path / "one"), BaseDirectory(tmp_path / "two")  # R-C01, reading 11
    for base, module_ in ((item, "first"), (two, "second")):
        base.save_task(RmodText(Task("pid", module_, frequency=1.0)))
    two.save_task(RmodText(Task("other", "m", frequency=1.0)))
    first, second = open_libraries([item, two])
    assert first.tasks["pid"].task.module == "first"
    assert list(second.tasks) == ["other"]
    assert sentences(second) == [
        f"pid.rmod: expected the name pid once on the search path, found it again, first in {item.path / 'module'}"
    ]
    assert second.faults[0].is_note
    assert second.left_out == ()


ODD = {
    "latin.rmod": (b"MODULE m\nDESC caf\xe9\n", "expected text in UTF-8, found the byte 0xe9"),
    "nul.rmod": (TEXT.replace("DESC", "DESC a\x00b").encode(), "expected printable text, found 'DESC a\\x00b'"),
    "long.rmod": (b"MODULE " + b"x " * 5_000_000, "expected a line of at most 1000000 letters, found 10000007"),
    "empty.rmod": (b"", "expected lines with keywords and EOF, found an empty file"),
    "9lives.rmod": (b"", "expected a name of letters, digits and _ . - that begins with a letter, found '9lives'"),
}


@pytest.mark.parametrize("name", ODD)
def test_odd_bytes_leave_one_file_out(base: BaseDirectory, name: str) -> None:
    data, expected = ODD[name]  # R-B07
    module(base, name).write_bytes(data)
    module(base, "good.rmod").write_text(TEXT)
    library = open_library(base)
    assert list(library.tasks) == ["good"]
    assert library.left_out == (str(module(base, name)),)
    assert f"{name}: {expected}" in sentences(library)


def test_line_ends_of_other_systems_and_a_byte_order_mark_mean_nothing(base: BaseDirectory) -> None:
    module(base, "dos.rmod").write_bytes(TEXT.replace("\n", "\r\n").encode())  # R-B01
    module(base, "mark.rmod").write_bytes(("\ufeff" + TEXT).encode())
    library = open_library(base)
    assert library.faults == ()
    assert {record.task.module for record in library.tasks.values()} == {"m"}
    assert rmod.write(library.tasks["mark"]) == "\ufeff" + TEXT


def test_what_is_no_file_is_told_and_nothing_waits_for_it(base: BaseDirectory) -> None:
    os.mkfifo(module(base, "pipe.rmod"))  # R-B07
    module(base, "folder.rmod").mkdir()
    module(base, "loop.rmod").symlink_to(module(base, "loop.rmod"))
    module(base, "gone.rmod").symlink_to(module(base, "nowhere"))
    module(base, "zero.rmod").symlink_to("/dev/zero")
    library = open_library(base)
    assert library.tasks == {}
    assert sentences(library) == [
        "folder.rmod: expected a file that can be read, found a directory",
        "gone.rmod: expected a file that can be read, found No such file or directory",
        "loop.rmod: expected a file that can be read, found Too many levels of symbolic links",
        "pipe.rmod: expected a file that can be read, found a pipe",
        "zero.rmod: expected a file that can be read, found a device",
    ]


@pytest.mark.skipif(os.geteuid() == 0, reason="an administrator reads every file")
def test_a_file_that_may_not_be_read_is_told(base: BaseDirectory) -> None:
    module(base, "secret.rmod").write_text(TEXT)  # R-B07
    module(base, "secret.rmod").chmod(0)
    assert sentences(open_library(base)) == [
        "secret.rmod: a file that can be read, found this user is not permitted to"
    ]


def test_a_folder_that_is_none_is_told_and_an_absent_one_is_empty(tmp_path: Path) -> None:
    assert open_library(BaseDirectory(tmp_path)).faults == ()  # R-B07, R-B08
    (tmp_path / "module").write_text("")
    library = open_library(BaseDirectory(tmp_path))
    assert sentences(library) == ["module: expected a folder that can be read, found Not a directory"]
    nowhere = open_library(BaseDirectory(tmp_path / "nowhere"))
    assert sentences(nowhere) == ["nowhere: expected a base directory, found none"]


def test_names_that_differ_only_in_case_are_two_tasks_with_a_note(base: BaseDirectory) -> None:
    for name in ("Pid", "pid"):
        module(base, f"{name}.rmod").write_text(TEXT)
    library = open_library(base)
    assert sorted(library.tasks) == ["Pid", "pid"]
    assert sentences(library) == [
        "pid.rmod: expected names that differ in more than small and large letters, found pid beside Pid"
    ]
    assert library.left_out == ()


def test_a_parameter_given_twice_is_noted_and_the_task_is_there(base: BaseDirectory) -> None:
    module(base, "twice.rmod").write_text(TEXT.replace("EOF", "LOCAL\nGAIN 1\nGAIN 2\nEOF"))
    library = open_library(base)
    assert library.tasks["twice"].task.local == (LocalLine("GAIN", ("1",)), LocalLine("GAIN", ("2",)))
    assert sentences(library) == ["twice.rmod: expected GAIN once, found 'GAIN 2' again"]
    assert library.left_out == ()


def test_of_open_libraries_only_what_was_written_is_read_again(tmp_path: Path) -> None:
    item, two = BaseDirectory(tmp_path / "one"), BaseDirectory(tmp_path / "two")  # R-C01
    for base, name in ((item, "pid"), (item, "pd"), (two, "pid"), (two, "other")):
        base.save_task(RmodText(Task(name, "m", frequency=1.0)))
    (item.path / "module" / "bad.rmod").write_text("MODULE\n")
    former = open_libraries([item, two])
    assert all(map(lambda a, b: a is b, reopen_libraries([item, two], former, frozenset()), former))
    for base in (item, two):
        base.task_file("pd" if base is item else "other").write_text(TEXT.replace("10", "20"))
    again = reopen_libraries([item, two], former, {item.task_file("pd"), item.task_file("bad"), item.task_file("pid")})
    assert again[0].tasks["pd"].task.frequency == 20.0
    assert again[0].tasks["pid"] is former[0].tasks["pid"]
    assert again[0].faults == former[0].faults
    assert again[1] is former[1]
    item.task_file("pid").unlink()
    (two.path / "module" / "m.py").write_text("")
    gone = reopen_libraries([item, two], again, {item.task_file("pid")})
    assert ("pid" in gone[0].tasks, "pid" in gone[1].tasks) == (False, True)
    assert gone[1].modules == {"m"}
    assert reopen_libraries([two], gone, frozenset())[0].tasks == gone[1].tasks
    assert open_libraries([item, two]) == reopen_libraries([item, two], gone, {two.task_file("other")})
