"""One rule for the versions of all formats: older files load, newer ones are refused whole (R-B06, R-B09)."""

from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st
from tests.contract.test_formats import every_format
from tests.files.models import FORMATS, TYPES, Format, branches, flows

from onika.files import appl, conf, onk, rmod
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.words.fault import Refusal
from onika.words.reason import Reason

TASK = rmod.write(RmodText(Task("t", "m", frequency=10.0, object_type="Joint job")))
CONF = conf.write(Configuration("c", (Placed("a"), Placed("b"))))
ROWS = "PICT        " + "8" * 32 + "\n"
ICON = "ROUTINE     {}\nMARKER      no\nONIKON      Joint {}\nDESC\n{}" + ROWS * 32
JOINT = ICON.format("go", "job", "UI          none\n") + ICON.format("there", "object", "UI 1 2\nUI a line\n")
APPL = f"VERSION 1.3\nAPPLTYPE conditional\nFLOW\n{JOINT}ENDFLOW\nEOF\n"
ONK = f"VERSION 1.3\nONIKON Complete job\nDESC\nUI none\n{ROWS * 32}EOF\n"

EXTENDED = {
    "a rule of a supermodule": (conf.read, CONF.replace("EOF", "GROUP       arm a b\nRULE        a b\n\nEOF")),
    "a target of two shapes": (
        lambda text, name, place: appl.read(text, name, place, TYPES),
        APPL.replace("MARKER      no\n", "MARKER      no\nSHAPES      2\n", 1),
    ),
    "a branch within a flow": (
        lambda text, name, place: appl.read(text, name, place, TYPES),
        APPL.replace("ENDFLOW", "BRANCH\nFLOW\nENDFLOW\nENDBRANCH\nENDFLOW"),
    ),
    "a larger picture": (
        lambda text, name, place: onk.read(text, name, place, TYPES),
        ONK.replace(ROWS, ("PICT        " + "8" * 64 + "\n") * 2),
    ),
}


@pytest.mark.parametrize("text", [TASK, CONF, APPL, ONK])
def test_the_files_of_these_tests_are_right(text: str) -> None:
    faults = [
        rmod.read(text, "t", "f")[1],
        conf.read(text, "c", "f")[1],
        appl.read(text, "a", "f", TYPES)[1],
        onk.read(text, "o", "f", TYPES)[1],
    ]
    assert () in faults


@pytest.mark.parametrize("extension", EXTENDED)
def test_a_planned_extension_is_refused_with_one_fault_under_its_version_and_by_line_under_ours(extension: str) -> None:
    read, text = EXTENDED[extension]  # R-B09
    newer = text.replace("1.3", "1.4", 1)
    value, faults = read(newer, "x", "f")
    assert value is None
    refusal = Reason.of("files.version_newer_extended", version="1.3", extended="2.0", given="1.4")
    assert [fault.reason for fault in faults] == [refusal]
    value, faults = read(text, "x", "f")
    assert value is None
    assert all(fault.place.line > 1 for fault in faults)


def test_a_new_line_of_the_onika_block_is_refused_by_name() -> None:
    text = TASK.replace("OBJECT      Joint job\n", "OBJECT      Joint job\nMEMBERS     a b\n")  # R-B09
    record, (fault,) = rmod.read(text, "t", "f")
    assert record is None
    assert fault.reason == Reason.of(
        "files.keywords_expected",
        keywords=("TARGET", "LOCAL"),
        line="'MEMBERS a b'",
    )


@every_format
@given(data=st.data())
@settings(max_examples=5, deadline=None)
def test_a_newer_file_is_refused_whole_and_says_so_once(form: Format, data: st.DataObject) -> None:
    text = form.write(data.draw(form.models))  # R-B06
    if "VERSION" not in text.partition("\n")[0]:
        return  # tasks and pictures have none
    body = text.partition("\n")[2].replace("EOF", "NEW words\nEOF\nEOF")
    for version in ("1.4", "1.3.0.1", "1.9", "2.0.1", "2.1", "10.0", *(() if form.is_extended else ("2", "2.0"))):
        _, faults = form.read(f"VERSION {version}\n{body}")
        assert [fault.reason.args["given"] for fault in faults] == [version]
        assert not faults[0].is_note


@pytest.mark.parametrize("version", ["", "VERSION 1.2\n", "VERSION 0.9\n"])
def test_an_older_file_is_brought_up_to_date_when_it_is_saved_and_keeps_its_comments(
    version: str, tmp_path: Path
) -> None:
    base = BaseDirectory(tmp_path)  # R-B06, R-B01
    path = base.configuration_file("old")
    path.parent.mkdir()
    path.write_text(f"# by hand\n{version}# first\nRMODFILE a\nCOORDS 1 2\n# where x meets\nLOCUS X\nCOORDS 3 4\nEOF\n")
    former, faults = base.open_configuration("old")
    assert former
    assert faults == ()
    base.save_configuration(former.value, former)
    text = path.read_text()
    assert [line for line in text.splitlines() if line.startswith("#")] == ["# by hand", "# first", "# where x meets"]
    assert "VERSION     1.3" in text
    assert base.configuration("old") == (former.value, ())
    for keyword in ("INLEFT", "FREQ", "RTPU", "CONNS", "NUMDOUBLEIN", "SHOW"):
        assert f"\n{keyword} " in text


def test_a_newer_file_is_not_lost_by_saving_one_of_its_name(tmp_path: Path) -> None:
    base = BaseDirectory(tmp_path)  # R-B06, R-B07
    path = base.configuration_file("c")
    path.parent.mkdir()
    newer = CONF.replace("1.3", "1.4")
    path.write_text(newer)
    assert base.open_configuration("c")[0] is None
    assert isinstance(base.save_configuration(Configuration("c")), Refusal)
    assert path.read_text() == newer


# -- the strategies of all these tests


def _parts(value: Any) -> list[Any]:
    """A value with all that is in it."""
    inner: list[Any] = []
    if is_dataclass(value):
        inner = [getattr(value, field.name) for field in fields(value)]
    elif isinstance(value, tuple):
        inner = list(value)
    return [value, *(part for item in inner for part in _parts(item))]


@pytest.mark.slow
def test_the_strategies_vary_every_field_of_every_value() -> None:
    seen: dict[tuple[type, str], set[str]] = {}  # R-B08

    @given(data=st.data())
    @settings(max_examples=150, deadline=None, database=None, derandomize=True)
    def look(data: st.DataObject) -> None:
        for values in (*(form.models for form in FORMATS), branches(flows)):  # a branch is rare in an application
            for part in _parts(data.draw(values)):
                if is_dataclass(part):
                    for field in fields(part):
                        seen.setdefault((type(part), field.name), set()).add(repr(getattr(part, field.name)))

    look()
    places = {("Icon", "line"), ("Hole", "line"), ("Hole", "kept"), ("Branch", "line")}
    places |= {(kind, "number") for kind in ("Icon", "Hole", "Branch")}  # given while they are open
    fixed = places | {("Task", "name"), ("Configuration", "name"), ("Application", "name")}
    fixed |= {("RobotText", "name"), ("WorldText", "name")}
    fixed |= {
        (kind, "lines") for kind in ("RobotText", "RobotArm", "RobotAxes", "RobotGripper", "RobotBase", "WorldText")
    }
    fixed |= {(f"{kind}Block", "lines") for kind in ("Part", "Place", "Switch", "Lamp", "Button", "Sensor", "Camera")}
    alike = {(kind.__name__, name) for (kind, name), values in seen.items() if len(values) < 2}
    assert alike == fixed
