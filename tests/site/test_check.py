"""`onika check` and `onika new module`: what is wrong with files, and a new file that is right (B07)."""

import os
import re
import subprocess
import sys

import pytest

from kit.labs.laboratory import HOLE, Laboratory, job, joints, target
from onika.cli import main
from onika.store.shipped import shipped_directories

pytestmark = [pytest.mark.site, pytest.mark.usefixtures("warm_runtimes")]

LINE = re.compile(r"(?P<place>.+?)(:\d+)?: expected .+, found .+; instead: .+")


def check(capsys, *words):
    code = main(["check", *map(str, words)])
    *faults, last = capsys.readouterr().out.splitlines()
    assert re.fullmatch(r"\d+ files? read, (no|\d+) faults?", last)
    return code, faults, last


@pytest.mark.parametrize("base", shipped_directories(), ids=lambda path: path.name)
def test_a_shipped_base_directory_has_no_fault(capsys, base):  # R-B07, R-E01
    code, faults, last = check(capsys, base)
    assert (code, faults) == (0, [])
    assert last.endswith(", no faults")


def plant(laboratory):
    """One fault of every kind, and where each of them is."""
    laboratory.module(
        "liar", "from onika.module import InVar, Module\n\nclass Liar(Module):\n    Y = InVar('double')\n"
    )
    laboratory.plain_task("liar", reads="X")
    laboratory.module("broken", "class Broken(:\n    pass\n")
    laboratory.plain_task("broken")
    laboratory.module("two", "from onika.module import Module\nclass A(Module): pass\nclass B(Module): pass\n")
    laboratory.module("idle", "x = 1\n")
    laboratory.plain_task("idle")
    laboratory.plain_task("ghost")
    laboratory.task("garbled", "MODULE      idle\nDESC        a task\nTASKTYPE    sometimes")
    laboratory.configuration("oddC", "liar fast")
    (laboratory.path / "dict").mkdir()
    (laboratory.path / "dict" / "odd.onk").write_text("VERSION 1.3\nONIKON Joint object\nUI NaN 0 0 0 0 0\nUI 1\nEOF\n")
    (laboratory.path / "module" / "noise.rmod").write_bytes(b"MODULE\xff\xfe")
    laboratory.application("holey", [job("jmoveC", "Joint job"), HOLE])
    laboratory.application("wild", [job("jmoveC", "Joint job"), joints("wild", 0.0, 99.0, 0.0, 0.0, 0.0, 0.0)])
    laboratory.application("odd", [job("opengripC", "Wobbly job"), target("x", "Joint object", "inf 0 0 0 0 0", "1")])
    cut = laboratory.application("cut", [job("opengripC")])
    cut.write_text(cut.read_text()[:-40])
    return {
        "liar.rmod", "broken.py:1", "two.py", "idle.py", "ghost.rmod", "garbled.rmod:", "oddC.conf:", "odd.onk:",
        "noise.rmod:1", "holey.appl", "wild.appl", "odd.appl:", "cut.appl:",
    }  # fmt: skip


def test_every_planted_fault_is_reported_with_its_place(capsys, tmp_path):  # R-B07, R-E01
    planted = plant(Laboratory(tmp_path))
    code, lines, last = check(capsys, tmp_path)
    faults = [line for line in lines if not line.startswith("note: ")]
    assert code == 1
    assert all(LINE.fullmatch(fault) for fault in faults), faults
    missed = {place for place in planted if not any(f"/{place}" in fault for fault in faults)}
    assert missed == set()
    assert f"{len(faults)} faults" in last
    assert faults == sorted(set(faults)) or len(faults) == len(set(faults))


def test_one_file_is_checked_by_itself(capsys, tmp_path):  # R-B07
    laboratory = Laboratory(tmp_path)
    plant(laboratory)
    code, faults, last = check(capsys, tmp_path / "conf" / "oddC.conf")
    assert code == 1
    assert last.startswith("1 file read, ")
    assert all("oddC.conf:" in fault for fault in faults)


def test_nothing_at_a_path_is_a_fault(capsys, tmp_path):  # R-B07
    code, faults, _ = check(capsys, tmp_path / "nowhere")
    assert code == 1
    assert "nowhere: expected a base directory or a file, found nothing there" in faults[0]


def test_several_paths_are_checked_together(capsys, tmp_path):  # R-B07
    code, faults, last = check(capsys, *shipped_directories()[:2], tmp_path / "nowhere")
    assert (code, len(faults)) == (1, 1)
    assert last.endswith(", 1 fault")


def test_a_new_module_is_right_and_its_test_passes(capsys, tmp_path):  # R-K05
    assert main(["new", "module", "damper", "--in", str(tmp_path)]) == 0
    *paths, advice = capsys.readouterr().out.splitlines()
    assert [path.rpartition("/")[2] for path in paths] == ["damper.py", "damper.rmod", "test_damper.py"]
    assert "onika check" in advice
    assert check(capsys, tmp_path)[:2] == (0, [])
    command = [sys.executable, "-m", "pytest", "-q", "-W", "error", "-p", "no:cacheprovider", paths[-1]]
    tested = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert tested.returncode == 0, tested.stdout
    assert "1 passed" in tested.stdout


def test_the_doctor_says_what_there_is_and_what_it_costs(capsys):  # law 31
    code = main(["doctor"])
    lines = capsys.readouterr().out.splitlines()
    for name in ("system", "python", "processors", "SCHED_FIFO", "memory lock", "mujoco", "ruckig", "graphics"):
        assert any(line[4:].startswith(name) for line in lines), name
    lacking = [line for line in lines if line.startswith("no  ")]
    assert code == (1 if lacking else 0)
    assert len([line for line in lines if "cost: " in line]) == len(lacking)


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("run", "go_home", "--expect", "LAMP = 1"), "expected an address, a comparison and a number"),
        (("run", "go_home", "--expect", "__import__('os').abort() == 1"), "expected an address"),
        (("run", "go_home", "--settle", "soon"), "expected seconds from 0 to 3600, found 'soon'"),
        (("run", "go_home", "--settle", "-1"), "expected seconds from 0 to 3600, found '-1'"),
        (("run", "go_home", "--settle", "nan"), "expected seconds from 0 to 3600, found 'nan'"),
        (("run", "go_home", "--answer", "gauge"), "expected TASK.NAME=VALUES, found 'gauge'"),
        (("run", "go_home", "--seed", "many"), "expected a whole number of at most 18 digits, found 'many'"),
        (("run", "go_home", "--local", "/no/such/place"), "expected a base directory, found none at '/no/such/place'"),
        (("check", "/", "--local", "/no/such/place"), "expected a base directory, found none at '/no/such/place'"),
        (("dance",), "invalid choice: 'dance'"),
        (("--port", "many"), "invalid int value"),
    ],
)
def test_a_wrong_command_line_says_what_was_expected(capsys, words, expected):  # R-B07
    with pytest.raises(SystemExit) as ended:
        main(list(words))
    assert ended.value.code == 2
    assert expected in capsys.readouterr().err


def nine(text):
    """The same with a cell of colour 9 in the second row of its first picture, and a coloured cell on the border."""
    return text.replace("8" * 32 + "\nPICT        " + "8" * 32, "8" * 32 + "\nPICT        18898" + "8" * 27, 1)


def test_a_colour_or_border_cell_is_a_note_and_the_run_goes_on(capsys, tmp_path):  # reading 38, R-B11, R-B07
    laboratory = Laboratory(tmp_path)
    path = laboratory.application("odd", [nine(job("opengripC"))])
    code, lines, last = check(capsys, path)
    assert code == 0
    assert last == "1 file read, no faults"
    assert [line.partition(" expected ")[2] for line in lines] == [
        "colours from 0 to 8, found a 9; instead: it is read as black",
        "a black border, found another colour on it; instead: the border is read as black",
    ]
    assert all(line.startswith(f"note: {path}:13: ") for line in lines)
    assert main(["run", str(path), "--virtual"]) == 0
    output = capsys.readouterr().out
    assert "note: " in output
    assert "completed" in output


def test_a_job_of_unknown_type_acts_as_a_complete_one_with_a_note(capsys, tmp_path):  # R-D16
    path = Laboratory(tmp_path).application("odd", [job("opengripC", "Wobbly job")])
    code, lines, _ = check(capsys, path)
    assert code == 0
    assert lines[0].startswith(f"note: {path}:9: expected a type of icon that the syntax defines")
    assert main(["run", str(path), "--virtual"]) == 0
    assert "completed" in capsys.readouterr().out


def test_one_thing_is_told_once_and_named_as_it_was_given(capsys, tmp_path, monkeypatch):  # R-B07
    laboratory = Laboratory(tmp_path / "lab")
    laboratory.module("wink", "from onika.module import Module, finish\nclass Wink(Module):\n    trigger = True\n")
    laboratory.plain_task("wink", local="COLOUR red\n")
    laboratory.configuration("winkC", "wink 100")
    laboratory.application("wink", [job("winkC")])
    monkeypatch.chdir(tmp_path)
    for given in ("lab", str(tmp_path / "lab")):
        code, lines, _ = check(capsys, given)
        assert code == 0
        (note,) = lines
        assert note.startswith(f"note: {given}/module/wink.rmod: LOCAL COLOUR is no parameter")
    monkeypatch.chdir(tmp_path / "lab")
    assert check(capsys, ".")[1] == [note.replace(f"{tmp_path}/lab/", "")]


@pytest.mark.parametrize(
    ("name", "damage", "expected"),
    [
        ("conf/winkC.conf", lambda text: text.replace("COORDS", "CORDS"), "COORDS"),
        ("module/wink.rmod", lambda text: text.replace("periodic", "sometimes"), "periodic, synchronous or aperiodic"),
        ("module/wink.rmod", lambda text: text.replace("MODULE", "MODUL"), "MODULE"),
        ("module/wink.py", lambda text: text + "class Broken(:\n", "Python"),
        ("module/wink.py", None, "wink.py beside it"),
    ],
)
def test_one_cause_gives_one_fault(capsys, tmp_path, name, damage, expected):  # R-B07, R-E01
    laboratory = Laboratory(tmp_path)
    laboratory.module("wink", "from onika.module import Module, finish\nclass Wink(Module):\n    trigger = True\n")
    laboratory.plain_task("wink")
    laboratory.configuration("winkC", "wink 100")
    laboratory.application("wink", [job("winkC"), job("winkC")])
    path = tmp_path / name
    if damage:
        path.write_text(damage(path.read_text()))
    else:
        path.unlink()
    code, lines, _ = check(capsys, tmp_path)
    assert code == 1
    assert len(lines) == 1, lines
    assert f"expected {expected}" in lines[0]


def test_what_is_named_like_a_file_and_is_none_is_told_and_never_waited_for(capsys, tmp_path):  # R-B07
    (tmp_path / "conf").mkdir()
    (tmp_path / "module" / "folder.rmod").mkdir(parents=True)
    os.mkfifo(tmp_path / "module" / "pipe.rmod")
    os.mkfifo(tmp_path / "module" / "pipe.py")
    (tmp_path / "conf" / "loop.conf").symlink_to("loop.conf")
    (tmp_path / "conf" / "gone.conf").symlink_to("nowhere")
    (tmp_path / "conf" / "zero.conf").symlink_to("/dev/zero")
    code, lines, _ = check(capsys, tmp_path)
    assert code == 1
    faults = [line.removeprefix(f"{tmp_path}/").partition("; instead")[0] for line in lines]
    assert faults == [
        "conf/gone.conf: expected a file that can be read, found No such file or directory",
        "conf/loop.conf: expected a file that can be read, found Too many levels of symbolic links",
        "conf/zero.conf: expected a file that can be read, found a device",
        "module/folder.rmod: expected a file that can be read, found a directory",
        "module/pipe.py: expected a file that can be read, found a pipe",
        "module/pipe.rmod: expected a file that can be read, found a pipe",
    ]
    code, lines, _ = check(capsys, tmp_path / "module" / "pipe.rmod")
    assert (code, len(lines)) == (1, 1)
