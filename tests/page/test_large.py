"""A canvas of five hundred boxes."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory

pytestmark = pytest.mark.page

COUNT = 500


@pytest.fixture(scope="module")
def program(begin, tmp_path_factory):
    """The environment with five hundred tasks, each of which reads what the one before it writes."""
    lab = Laboratory(tmp_path_factory.mktemp("large") / "many")
    blocks = []
    for k in range(COUNT):
        lab.module(f"m{k}", "from onika.module import Module\n\n\nclass Link(Module):\n    pass\n")
        lab.task(
            f"t{k}",
            f"MODULE  m{k}\nDESC  one of many\nINCONST  none\nOUTCONST  none\nINVAR  {f'V{k - 1}' if k else 'none'}\n"
            f"OUTVAR  V{k}\nTASKTYPE  periodic\nFREQ  10\n",
        )
        place = f"{100 + 260 * (k % 25)} {100 + 160 * (k // 25)}"
        blocks.append(f"RMODFILE    t{k}\nCOORDS      {place}\nINLEFT      yes\nFREQ        10\nRTPU        unknown\n")
    path = lab.path / "conf" / "manyC.conf"
    path.parent.mkdir()
    path.write_text("VERSION     1.3\n\n" + "\n".join(blocks) + "\nEOF\n")
    return begin(f"--base={lab.path}", "--no-connect", "manyC")


def test_five_hundred_boxes_open_are_dragged_and_taken_back(program, page, people):  # R-G07, R-C10
    me = people(program.enter(page))
    expect(me.canvas.locator("[data-task]").nth(40)).to_be_visible(timeout=20_000)
    page.keyboard.press("1")
    expect(me.canvas.locator("[data-task]")).to_have_count(COUNT, timeout=20_000)
    frames = me.canvas.locator("path.box")  # from afar one outline is all boxes that look alike
    expect(frames).to_have_count(1)
    assert (frames.get_attribute("d") or "").count("M") == COUNT
    page.keyboard.press("0")
    task = page.evaluate(
        """() => [...document.querySelectorAll('[data-task]')].find((one) => { const b = one.getBoundingClientRect()
        return b.left > 400 && b.right < 1000 && b.top > 200 && b.bottom < 560 })?.dataset.task"""
    )
    assert task
    before = me.corner(task)
    box = me.box(task).bounding_box()
    page.mouse.move(box["x"] + 40, box["y"] + 15)
    page.mouse.down()
    took = page.evaluate("performance.now()")
    page.mouse.move(box["x"] + 140, box["y"] + 75, steps=20)
    page.mouse.up()
    took = page.evaluate("performance.now()") - took
    expect(page.get_by_role("button", name=f"Undo: moving {task}")).to_be_enabled()
    assert me.corner(task) != before
    assert took < 8_000, "twenty steps of a drag"
    page.keyboard.press("Control+z")
    me.stands(task, *before)


def test_a_library_of_five_hundred_scrolls_and_draws_only_what_is_seen(program, page, people):  # R-C01
    me = people(program.enter(page))
    me.libraries("many")
    libraries = page.get_by_role("group", name="many")
    assert libraries.get_by_role("button").count() < 80
    page.keyboard.press("Control+f")
    page.keyboard.type("t499")
    page.keyboard.press("Enter")
    expect(me.sheet.get_by_role("heading", name="t499")).to_be_visible()
    expect(me.icon("t499")).to_have_accessible_name(re.compile("placed already"))
