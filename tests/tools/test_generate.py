import re
from pathlib import Path
from typing import get_args

import pytest

import generate
import message_page
from onika.engine.flow import FlowState
from onika.link.state import LinkState
from onika.model.lifecycle import State
from onika.wire import event, request

ROOT = Path(__file__).parents[2]
PAGE = "docs/lifecycles.md"
LABS = ROOT / "src" / "onika" / "labs"


def test_every_state_of_every_lifecycle_is_on_the_page():
    page = generate.lifecycles()
    assert page.count("```mermaid") == 3
    for state in (*State, *FlowState, *LinkState):
        assert f" {state.value}" in page


@pytest.fixture
def two_pages(monkeypatch):
    """Two pages that cost little, in place of all: what becomes of a page does not depend on what it shows."""
    monkeypatch.setattr(generate, "PAGES", {PAGE: generate.lifecycles, "docs/engine.md": generate.engine_page.page})


def test_a_page_that_was_changed_by_hand_is_named_and_not_written_by_a_check(two_pages, tmp_path, capsys):
    generate.write(tmp_path)
    (tmp_path / PAGE).write_text("by hand")
    assert generate.main(["--check", "--root", str(tmp_path)]) == 1
    assert capsys.readouterr().out.startswith(PAGE)
    assert (tmp_path / PAGE).read_text() == "by hand"


def test_a_table_that_has_changed_makes_its_page_stale(two_pages, tmp_path, monkeypatch):
    generate.write(tmp_path)
    monkeypatch.setattr(generate, "_HEAD", "more\n")
    assert list(generate.stale(tmp_path)) == [PAGE]


def test_missing_pages_are_written_once(two_pages, tmp_path, capsys):
    assert generate.main(["--root", str(tmp_path)]) == 0
    assert generate.main(["--root", str(tmp_path)]) == 0
    assert capsys.readouterr().out.split() == [PAGE, "docs/engine.md"]
    assert generate.main(["--check", "--root", str(tmp_path)]) == 0


def test_every_shipped_file_is_on_the_page_of_the_laboratory():
    page = generate.laboratory()
    shipped = [path for path in LABS.glob("*/*/*") if path.suffix in (".rmod", ".conf", ".appl")]
    assert shipped
    for path in shipped:
        assert f"| `{path.stem}` | {path.parts[-3]} |" in page or f"### `{path.stem}`\n\nIn `{path.parts[-3]}`" in page


def test_a_port_stands_on_the_page_by_its_name_in_the_table():
    page = generate.laboratory()
    assert "| OUTVAR | `Q^_MEZ` (`Y^` in the code) | double[NDOF] | rad/s |" in page
    head = "| `Q^_MEZ` | double[NDOF] or double[6] | rad/s | "
    row = next(line for line in page.splitlines() if line.startswith(head))
    assert all(f" `{task}` " in row for task in ("diff", "gravcomp", "pd"))


def test_a_device_and_a_target_stand_on_the_page_with_their_fields():
    page = generate.laboratory()
    assert "| `boxes:gripper_left` | `opening` `speed` `force` | `signal` | `gripper` |" in page
    takers = "`preshape` `calibration` `jtraj` `jvia` `planner` `jramp` `jruckig`"
    assert f"| Joint object | `endpoint` | double[NDOF] | rad | {takers} |" in page


def test_bounds_of_an_input_are_told_by_number_or_by_the_constant_that_holds_them():
    page = generate.laboratory()
    assert "| `endpoint` | double[NDOF] | rad | `QMIN` to `QMAX` |" in page
    assert "| `duration` | double | s | 0.1 to 600 |" in page


def test_every_message_is_on_its_page_with_its_fields():  # R-A19
    page = message_page.page()
    for argument in (*get_args(request.Request), *get_args(request.Response), *get_args(event.Event)):
        assert f"### {argument.__name__}\n" in page
        assert all(f"| `{name}` |" in page for name in argument.__struct_fields__)


def test_every_part_that_a_message_is_made_of_is_on_its_page():  # R-A19
    page = message_page.page()
    kinds = re.findall(r"^\| `\w+` \| `(.*?)` \|", page, re.MULTILINE)
    words = {"Any", "Index", "Instruction", "None", "Reason", "Site", "Span"}
    named = {word for kind in kinds for word in re.findall(r"\b[A-Z]\w+", kind)} - words
    assert named
    assert [name for name in sorted(named) if f"### {name}\n" not in page] == []
