from pathlib import Path

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from onika.desk.run import survey as room
from onika.desk.run.survey import survey
from onika.store.site import open_site
from onika.wire import request
from onika.words.reason import Reason

MODULE = "from onika.module import InVar, Module\nclass Wink(Module):\n    Y = InVar('double')\n"


class FakeRuntime:
    """Finds nothing; keeps what it was asked."""

    messages = []  # noqa: RUF012 - the test looks at it

    def __init__(self, rtpus, is_virtual):
        self.messages.append((rtpus, is_virtual))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def ask(self, message):
        self.messages.append(message)
        return request.Prepared(
            (request.FaultText("from.runtime", 1, Reason.plain("expected one, found two"), Reason.plain("three")),)
        )


@pytest.fixture
def laboratory(tmp_path):
    return Laboratory(tmp_path)


@pytest.fixture
def site(tmp_path):
    return open_site([], {}, None)


@pytest.fixture
def runtime(monkeypatch):
    FakeRuntime.messages = []
    monkeypatch.setattr(room, "LaunchedRuntime", FakeRuntime)
    return FakeRuntime


def places(faults):
    return [str(fault.place).rpartition("/")[2] for fault in faults]


def test_every_file_of_every_kind_is_read(laboratory, site, runtime):  # R-B07
    laboratory.module("wink", MODULE)
    laboratory.plain_task("wink", reads="Y")
    laboratory.configuration("winkC", "wink 100")
    laboratory.application("go", [job("winkC")])
    (laboratory.path / "dict").mkdir()
    (laboratory.path / "dict" / "bad.onk").write_text("nonsense\n")
    (laboratory.path / "prefs").mkdir()
    for name in ("OnikaUpperSetUp.dta", "OnikaStart.dta", ".onika", "notes.txt"):
        (laboratory.path / "prefs" / name).write_text("nonsense\n")
    files, faults = survey(laboratory.path, site)
    assert {file.name for file in files} >= {
        "wink.py",
        "wink.rmod",
        "winkC.conf",
        "go.appl",
        "bad.onk",
        "OnikaStart.dta",
    }
    assert "notes.txt" not in {file.name for file in files}
    files = {place.partition(":")[0] for place in places(faults)}
    assert files >= {"bad.onk", "OnikaUpperSetUp.dta", "OnikaStart.dta", "from.runtime"}
    assert files.isdisjoint({"wink.rmod", "winkC.conf"})
    assert faults == sorted(set(faults))


def test_tasks_and_applications_are_judged_by_their_modules(laboratory, site, runtime):  # R-B07, R-E01
    laboratory.module("wink", MODULE)
    laboratory.plain_task("wink", reads="Y")
    laboratory.configuration("winkC", "wink 100 rt3")
    laboratory.application("go", [job("winkC")])
    survey(laboratory.path, site)
    started, inspect, prepare = runtime.messages
    assert started == (("rt3",), True)
    assert [task.name for task in inspect.tasks] == ["wink"]
    assert [code.module for code in inspect.code] == ["wink"]
    assert prepare.plan.application == "go"


def test_a_module_that_no_task_uses_is_looked_at_too(laboratory, site, runtime):  # R-B07
    laboratory.module("idle", MODULE)
    survey(laboratory.path, site)
    assert [code.module for code in runtime.messages[1].code] == ["idle"]


def test_a_task_without_code_is_a_fault(laboratory, site, runtime):  # R-B01
    laboratory.plain_task("ghost")
    _, faults = survey(laboratory.path, site)
    assert places(faults) == ["ghost.rmod"]
    assert faults[0].reason == Reason.of("desk.code_missing", module="ghost")
    assert runtime.messages == []


def test_code_that_is_no_text_is_a_fault(laboratory, site, runtime):  # R-B07
    laboratory.plain_task("wink")
    laboratory.module("wink", "")
    (laboratory.path / "module" / "wink.py").write_bytes(b"\xff")
    assert "wink.py:1" in places(survey(laboratory.path, site)[1])


def test_a_task_may_use_code_of_the_search_path(laboratory, site, runtime):  # reading 11
    laboratory.task(
        "slow_open",
        "MODULE opengrip\nDESC slow\nINCONST none\nOUTCONST none\n"
        "INVAR GRIP_MEZ\nOUTVAR GRIP\nTASKTYPE periodic\nFREQ 20",
    )
    survey(laboratory.path, site)
    assert runtime.messages[1].code[0].path.endswith("puma/module/opengrip.py")


def test_one_file_is_surveyed_alone(laboratory, site, runtime):  # R-B07
    path = laboratory.configuration("winkC", "wink fast")
    laboratory.plain_task("ghost")
    files, faults = survey(path, site)
    assert files == [path]
    assert {place.partition(":")[0] for place in places(faults)} == {"winkC.conf"}


def test_nothing_there_is_a_fault(tmp_path, site, runtime):  # R-B07
    files, (fault,) = survey(tmp_path / "nowhere", site)
    assert (files, fault.reason) == ([], Reason.of("desk.nothing_there"))


def test_an_application_is_prepared_with_what_its_own_directory_holds(laboratory, site, runtime):  # reading 35
    path = laboratory.application("go", [job("jmoveC", "Joint job"), joints("far", 9.0, 0.0, 0.0, 0.0, 0.0, 0.0)])
    survey(path, site)
    (prepare,) = [message for message in runtime.messages if isinstance(message, request.Prepare)]
    assert prepare.targets[0].values[0] == 9.0


def test_notes_are_told_apart(laboratory, site, runtime, tmp_path, monkeypatch):  # R-B07, reading 38
    (laboratory.path / "dict").mkdir()
    picture = "PICT        " + "9" * 32 + "\n"
    text = f"VERSION 1.3\nONIKON Complete job\nDESC\nUI none\n{picture * 32}EOF\n"
    (laboratory.path / "dict" / "nine.onk").write_text(text)
    monkeypatch.chdir(tmp_path.parent)
    notes = []
    files, faults = survey(Path(tmp_path.name), site, notes.append)
    assert faults == []
    assert [str(file) for file in files] == [f"{tmp_path.name}/dict/nine.onk"]
    (note,) = notes
    assert str(note).startswith(f"{tmp_path.name}/dict/nine.onk:5: expected colours from 0 to 8")


def test_a_task_that_is_nowhere_is_a_fault_of_its_configuration(laboratory, site, runtime):  # R-B07, reading 11
    laboratory.configuration("winkC", "wink 100")
    _, faults = survey(laboratory.path, site)
    assert [fault.reason for fault in faults] == [Reason.of("desk.tasks_not_on_path", name="wink")]


def test_a_file_of_none_of_our_formats_is_a_fault(tmp_path, site, runtime):  # R-B07
    (tmp_path / "README.md").write_text("hello\n")
    _, (fault,) = survey(tmp_path / "README.md", site)
    assert fault.reason == Reason.of("desk.format_unknown")


def test_a_folder_named_like_a_file_is_a_fault(tmp_path, site, runtime):  # R-B07
    (tmp_path / "module" / "x.rmod").mkdir(parents=True)
    _, (fault,) = survey(tmp_path, site)
    assert (fault.place.file, str(fault.reason)) == (
        str(tmp_path / "module" / "x.rmod"),
        "expected a file that can be read, found a directory",
    )


def test_base_directories_in_a_folder_are_each_checked(tmp_path, site, runtime):  # R-B07
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        Laboratory(tmp_path / name).configuration(f"{name}C", "nowhere 100")
    files, faults = survey(tmp_path, site)
    assert [file.name for file in files] == ["oneC.conf", "otherC.conf"]
    assert places(faults) == ["oneC.conf:3", "otherC.conf:3"]


def test_a_directory_of_the_environment_checks_its_own_folder_and_the_base_directories_beside_it(
    tmp_path, site, runtime
):
    (tmp_path / "conf").mkdir()
    (tmp_path / "conf" / "ownC.conf").write_text("VERSION 1.3\nEOF\n")
    (tmp_path / "inner").mkdir()
    Laboratory(tmp_path / "inner").configuration("innerC", "nowhere 100")
    assert [file.name for file in survey(tmp_path, site)[0]] == ["ownC.conf", "innerC.conf"]


def test_a_folder_without_any_file_of_ours_is_a_fault(tmp_path, site, runtime):  # R-B07
    (tmp_path / "notes").mkdir()
    files, faults = survey(tmp_path, site)
    assert files == []
    assert faults[0].reason == Reason.of("desk.nothing_of_ours")


def test_a_puzzle_is_read_and_its_programs_are_looked_for(tmp_path, site, runtime):  # R-B07, R-G10
    (tmp_path / "puzzle").mkdir()
    file = tmp_path / "puzzle" / "light.puzzle"
    file.write_text("VERSION 2.0\nTITLE en A\nTASK en B\nLEVEL 1\nEXPECT LAMP == 1\nSOLUTION absent.al\nEOF\n")
    files, faults = survey(tmp_path, site)
    assert files == [file]
    assert [(fault.place.line, fault.reason.key) for fault in faults] == [(6, "desk.no_program_of_puzzle")]
    file.write_text("VERSION 2.0\nTITLE en A\nLEVEL 1\nEXPECT LAMP == 1\nEOF\n")
    assert [fault.place.line for fault in survey(tmp_path, site)[1]] == [3]
