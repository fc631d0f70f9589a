"""Somebody at the page, who finds things by role and name."""

import re

from playwright.sync_api import Locator, Page, expect


class Person:
    """Somebody at the page, who finds things by role and name."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.canvas = page.get_by_role("application", name=re.compile("^(canvas of|lienzo)"))
        self.sheet = page.get_by_role("complementary", name="Task sheet")
        self.strip = page.get_by_role("region", name="What is running")
        self.refusal = page.get_by_role("alertdialog", name="Refused")

    def box(self, task: str) -> Locator:
        """A task on the canvas, by name and whatever its state."""
        return self.canvas.get_by_role("button", name=re.compile(rf"^{re.escape(task)}(,|$)"))

    def locus(self, svar: str) -> Locator:
        return self.canvas.get_by_role("button", name=re.compile(rf"^locus {re.escape(svar)},"))

    def icon(self, task: str) -> Locator:
        """A task in the library that is shown."""
        return self.page.get_by_role("complementary", name="Task library").get_by_role(
            "button", name=re.compile(rf"^{re.escape(task)}, ")
        )

    def tab(self, name: str) -> Locator:
        return self.page.get_by_role("navigation").get_by_role("button", name=re.compile(rf"^{re.escape(name)}( |$)"))

    def libraries(self, library: str) -> None:
        self.page.get_by_role("group", name="Libraries").get_by_role(
            "button", name=re.compile(rf"^{library} \d")
        ).click()

    def blank(self) -> str:
        """A blank configuration comes to the front; its name."""
        tabs = self.page.get_by_role("navigation").get_by_role("listitem")
        before = tabs.count()
        self.page.locator("body").press("Alt+n")
        expect(tabs).to_have_count(before + 1)
        name = tabs.nth(before).get_by_role("button").first.inner_text().strip()
        expect(self.page.get_by_role("application", name=f"canvas of {name}")).to_be_visible()
        return name

    def at(self, x: float, y: float) -> tuple[float, float]:
        """A place of the canvas as a place of the page."""
        box = self.canvas.bounding_box()
        assert box
        return box["x"] + x, box["y"] + y

    def drag(self, what: Locator, x: float, y: float) -> None:
        """Drag by the mouse to a place of the canvas."""
        what.scroll_into_view_if_needed()
        box = what.bounding_box()
        assert box
        mouse = self.page.mouse
        mouse.move(box["x"] + box["width"] / 2, box["y"] + min(20, box["height"] / 2))
        mouse.down()
        to = self.at(x, y)
        mouse.move(to[0] - 8, to[1] - 8, steps=4)
        mouse.move(*to, steps=3)
        mouse.up()

    def place(self, *tasks: str) -> None:
        """Place tasks side by side, dragged from the library."""
        for task in tasks:
            k = self.canvas.locator("[data-task]").count()
            self.drag(self.icon(task), 140 + 230 * (k % 4), 120 + 200 * (k // 4))
            # The box is there before the answer that selects it.
            expect(self.box(task)).to_have_attribute("aria-pressed", "true")

    def remove(self, task: str) -> None:
        self.box(task).click()
        self.page.keyboard.press("Delete")
        expect(self.box(task)).to_have_count(0)

    def dot(self, svar: str) -> Locator:
        """What a mouse takes of a locus."""
        return self.canvas.locator(f'[data-locus="{svar}"] circle').first

    def corner(self, task: str) -> tuple[int, int]:
        """Where the upper left corner of a box stands in the scene."""
        return self._stands(f'[data-task="{task}"]')

    def spot(self, svar: str) -> tuple[int, int]:
        """Where a locus stands in the scene."""
        return self._stands(f'[data-locus="{svar}"]')

    def _stands(self, what: str) -> tuple[int, int]:
        moved = self.canvas.locator(what).get_attribute("transform") or ""
        x, y = re.findall(r"-?[\d.]+", moved)
        return round(float(x)), round(float(y))

    def stands(self, task: str, x: float, y: float) -> None:
        """Wait until a box stands there, give or take a step of the grid."""
        script = "([what, x, y]) => { const at = document.querySelector(what)?.transform.baseVal.consolidate()?.matrix;"
        script += " return at && Math.abs(at.e - x) <= 10 && Math.abs(at.f - y) <= 10 }"
        self.page.wait_for_function(script, arg=[f'[data-task="{task}"]', x, y], timeout=10_000)

    def state(self, task: str, state: str) -> None:
        """Wait until a task is in a state."""
        expect(self.canvas.get_by_role("button", name=re.compile(rf"^{task}, {state}"))).to_be_visible()
