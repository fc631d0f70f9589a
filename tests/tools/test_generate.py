import runpy
from pathlib import Path
from typing import get_args

import pytest

from onika.engine.flow import FlowState
from onika.link.state import LinkState
from onika.model.lifecycle import State
from onika.wire import event, request

ROOT = Path(__file__).parents[2]
PAGE = "docs/lifecycles.md"
LABORATORY = "docs/laboratory.md"
LABS = ROOT / "src" / "onika" / "labs"


@pytest.fixture
def tool():
    """The names of the tool; its functions see these very tables."""
    return runpy.run_path(str(ROOT / "tools" / "generate.py"))


def test_the_pages_of_this_repository_are_what_the_code_says(tool):
    assert tool["stale"](ROOT) == []


def test_every_state_of_every_lifecycle_is_on_the_page(tool):
    page = tool["lifecycles"]()
    assert page.count("```mermaid") == 3
    for state in (*State, *FlowState, *LinkState):
        assert f" {state.value}" in page


def test_a_page_that_was_changed_by_hand_is_named_and_not_written_by_a_check(tool, tmp_path, capsys):
    tool["write"](tmp_path)
    (tmp_path / PAGE).write_text("by hand")
    assert tool["main"](["--check", "--root", str(tmp_path)]) == 1
    assert capsys.readouterr().out.startswith(PAGE)
    assert (tmp_path / PAGE).read_text() == "by hand"


def test_a_table_that_has_changed_makes_its_page_stale(tool, tmp_path):
    tool["write"](tmp_path)
    tool["PAGES"][PAGE].__globals__["_HEAD"] += "more\n"
    assert tool["stale"](tmp_path) == [PAGE]


def test_missing_pages_are_written_once(tool, tmp_path, capsys):
    assert tool["main"](["--root", str(tmp_path)]) == 0
    assert tool["main"](["--root", str(tmp_path)]) == 0
    assert capsys.readouterr().out.split() == [
        "docs/engine.md",
        PAGE,
        LABORATORY,
        "docs/messages.md",
        "browser/src/api.gen.ts",
        "browser/src/texts/catalogue.es.gen.ts",
    ]
    assert tool["main"](["--check", "--root", str(tmp_path)]) == 0


def test_every_shipped_file_is_on_the_page_of_the_laboratory(tool):
    page = tool["laboratory"]()
    shipped = [path for path in LABS.glob("*/*/*") if path.suffix in (".rmod", ".conf", ".appl")]
    assert shipped
    for path in shipped:
        assert f"| `{path.stem}` | {path.parts[-3]} |" in page or f"### `{path.stem}`\n\nIn `{path.parts[-3]}`" in page


def test_a_port_stands_on_the_page_by_its_name_in_the_table(tool):
    page = tool["laboratory"]()
    assert "| OUTVAR | `Q^_MEZ` (`Y^` in the code) | double[NDOF] | rad/s |" in page
    assert "| `Q^_MEZ` | double[NDOF] | rad/s | `diff` | `gravcomp` `pd` |" in page


def test_a_device_and_a_target_stand_on_the_page_with_their_fields(tool):
    page = tool["laboratory"]()
    assert "| `boxes:gripper_left` | `opening` `speed` `force` | `signal` | `gripper` |" in page
    assert "| Joint object | `endpoint` | double[NDOF] | rad | `jtraj` `jvia` `planner` |" in page


def test_bounds_of_an_input_are_told_by_number_or_by_the_constant_that_holds_them(tool):
    page = tool["laboratory"]()
    assert "| `endpoint` | double[NDOF] | rad | `QMIN` to `QMAX` |" in page
    assert "| `duration` | double | s | 0.1 to 600 |" in page


def test_every_message_is_on_its_page_with_its_fields(tool):  # R-A19
    page = tool["messages"]()
    for one in (*get_args(request.Request), *get_args(request.Response), *get_args(event.Event)):
        assert f"### {one.__name__}\n" in page
        assert all(f"| `{name}` |" in page for name in one.__struct_fields__)
