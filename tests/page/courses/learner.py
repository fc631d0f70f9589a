"""Somebody who learns at the page, in a language, and does nothing but what the page offers."""

import re

from playwright.sync_api import Locator, Page, expect

from .words import texts

PATIENCE_MS = 60_000
SHIFT = ["Shift"]
LATE = re.compile(r"(was|came) late")
"""What is said of a device that the machine of the tests did not serve in time."""


class Learner:
    """Somebody who goes through courses, lesson by lesson."""

    def __init__(self, page: Page, language: str = "en") -> None:
        self.page = page
        self.texts = texts(language)
        self.workspace = page.get_by_role("region", name=self.t("upper.workspace"), exact=True)
        self.steps = self.workspace.locator("[data-step]")
        self.holes = page.locator(f"[data-step][aria-label^='{self.t('upper.hole').partition(':')[0]}']")
        self.menu = page.get_by_role("menu")
        self.run_panel = page.get_by_role("region", name=self.t("perform.title"), exact=True)
        self.panel = page.get_by_role("dialog").filter(has=page.get_by_role("combobox", name=self.t("tutorial.course")))

    def t(self, key: str, **gaps: object) -> str:
        """The words of a key."""
        words = self.texts.get(key, key)
        for name, value in gaps.items():
            words = words.replace(f"{{{name}}}", str(value))
        return words

    # -- the course

    def takes(self, course: str) -> None:
        """Choose a course, from its beginning."""
        self.panel.get_by_role("combobox", name=self.t("tutorial.course")).select_option(course)

    @property
    def lesson(self) -> Locator:
        """The lesson that is to be done."""
        return self.panel.locator("li[aria-current=step]")

    def is_at(self, lesson: str) -> None:
        """Wait until this one is the next to be done."""
        expect(self.lesson).to_contain_text(self.t(f"tutorial.{lesson}"), timeout=PATIENCE_MS)

    def has_done(self, count: int) -> None:
        """Wait until so many lessons have their tick."""
        expect(self.panel.locator("li.done")).to_have_count(count, timeout=PATIENCE_MS)

    # -- puzzles

    def opens(self, number: int) -> None:
        """Begin a puzzle of the course, by its place in the list."""
        puzzle = self.panel.locator("ol > li").nth(number)
        if puzzle.get_attribute("aria-current") is None:
            puzzle.get_by_role("button").first.click()
        puzzle.get_by_role("button", name=self.t("puzzle.begin"), exact=True).click()
        expect(puzzle.get_by_role("button", name=self.t("puzzle.again"), exact=True)).to_be_visible()

    def takes_hints(self) -> None:
        """All of the puzzle that is open, one after the other; each says how many are left."""
        puzzle = self.panel.locator("li[aria-current=step]")
        hints = puzzle.get_by_text(re.compile(self.t("puzzle.hintNumber", n="\\d+")))
        more = puzzle.get_by_role("button", name=re.compile(re.escape(self.t("puzzle.hint")).replace(r"\{n\}", r"\d+")))
        count = int(re.findall(r"\d+", more.inner_text())[0])
        for taken in range(count):
            expect(hints).to_have_count(taken)
            expect(more).to_contain_text(str(count - taken))
            more.click()
        expect(hints).to_have_count(count)
        expect(more).to_have_count(0)

    @property
    def verdict(self) -> Locator:
        """What came of the run."""
        return self.panel.get_by_role("status")

    def gets(self, key: str) -> None:
        """Run until this is the verdict; a run that stopped as this machine had no time for its robots is done anew."""
        wanted = self.verdict.filter(has_text=self.t(key))
        late = self.page.get_by_role("dialog").filter(has_text=LATE)
        for _ in range(3):
            self.runs()
            expect(wanted.or_(late)).to_be_visible(timeout=2 * PATIENCE_MS)
            if wanted.is_visible():
                break
            late.get_by_role("button", name=re.compile(self.t("stopped.abort"))).click()
            expect(late).to_have_count(0)
        expect(wanted).to_be_visible()

    # -- programs

    def icon(self, name: str) -> Locator:
        return self.page.locator(f"#onikon-{name}")

    def step(self, place: int) -> Locator:
        """What stands at a place, counted through all flows, the start icon of each with it."""
        return self.steps.nth(place)

    def begins(self, flows: int = 1) -> None:
        """A new application."""
        self.page.locator("body").press("Alt+n")
        form = self.page.get_by_role("dialog", name=self.t("newApplication.title"))
        if flows > 1:
            form.get_by_text(self.t("newApplication.parallel"), exact=True).click()
            form.get_by_label(self.t("newApplication.flows")).fill(str(flows))
        form.get_by_role("button", name=self.t("newApplication.create"), exact=True).click()
        expect(form).to_have_count(0)
        expect(self.steps).to_have_count(2 * flows)

    def puts(self, place: int, *names: str) -> None:
        """Behind what stands at a place, one after the other, by a click in the dictionary and a right click there."""
        for name in names:
            words = self._words_of(name)
            self.icon(name).click()
            self.step(place).click(button="right")
            place += 1
            expect(self.step(place)).to_have_attribute("aria-label", re.compile(f"^{re.escape(words)}"))

    def chooses(self, place: int, key: str) -> None:
        """From the menu of an icon."""
        self.step(place).click(button="right", modifiers=SHIFT)
        name = re.compile(f"^{re.escape(self.t(key))}")
        self.menu.get_by_role("menuitem", name=name).click()

    def adds_a_flow(self) -> None:
        """A second one beside the first, by the menu behind the start icon."""
        self._chooses_of_flows("upper.addFlow")
        expect(self.steps).to_have_count(4)
        self._chooses_of_flows("upper.makeParallel")
        expect(self.workspace.get_by_text(self.t("upper.parallelFlows", n=2))).to_be_visible()

    def _chooses_of_flows(self, key: str) -> None:
        self.step(0).click()
        self.page.keyboard.press("Shift+F10")
        self.menu.get_by_role("menuitem", name=re.compile(f"^{re.escape(self.t(key))}")).click()

    def copies(self, first: int, last: int, behind: int) -> None:
        """What stands from one place to another, behind a third one."""
        count = self.steps.count()
        self.step(first).click()
        self.step(last).click(modifiers=SHIFT)
        self.page.keyboard.press("Control+c")
        self.step(behind).click()
        self.page.keyboard.press("Control+v")
        expect(self.steps).to_have_count(count + last - first + 1)

    def tags(self, place: int, tag: str) -> None:
        self.chooses(place, "upper.tag")
        field = self.page.get_by_role("textbox", name=self.t("upper.tagTitle"))
        field.fill(tag)
        field.press("Enter")
        expect(field).to_have_count(0)

    def repeats(self, first: int, more: int, times: int) -> None:
        """What stands from one place on, so often."""
        self.step(first).click()
        for _ in range(more):
            self.page.keyboard.press("Shift+ArrowRight")
        self.step(first).click(button="right", modifiers=SHIFT)
        self.menu.get_by_role("menuitem", name=re.compile(f"^{re.escape(self.t('upper.repeat'))}")).click()
        field = self.page.get_by_role("textbox", name=self.t("upper.howOften"))
        field.fill(str(times))
        field.press("Enter")
        expect(field).to_have_count(0)

    def branches(self, place: int, flows: int, *conditions: str) -> None:
        """A branch behind what stands at a place."""
        self.step(place).click()
        self.chooses(place, "upper.insertBranch")
        form = self.page.get_by_role("form", name=self.t("upper.insertBranch"))
        form.get_by_label(self.t("upper.branchFlows"), exact=True).fill(str(flows))
        for number, condition in enumerate(conditions):
            key = "upper.branchElseIf" if number else "upper.branchIf"
            form.get_by_label(self.t(key, n=number)).fill(condition)
        form.get_by_role("button", name=self.t("upper.ok")).click()
        expect(form).to_have_count(0)

    def fills(self, *names: str) -> None:
        """Each empty flow of a branch, by an action."""
        empty = self.workspace.locator("[role=option]:not([data-step])")
        for left, name in zip(range(len(names), 0, -1), names, strict=True):
            expect(empty).to_have_count(left)
            self.icon(name).click()
            empty.first.click(button="right")
        expect(empty).to_have_count(0)

    def saves(self, name: str) -> None:
        """Under a name that it has for the first time."""
        self.page.locator("body").press("Control+s")
        panel = self.page.get_by_role("dialog", name=re.compile(self.t("save.title").partition(" {")[0]))
        panel.get_by_role("textbox").first.fill(name)
        panel.get_by_role("button", name=self.t("save.save"), exact=True).click()
        expect(panel).to_have_count(0)

    # -- runs

    def sees(self, example: str) -> None:
        """Open the program of the lesson, and run it."""
        self.lesson.get_by_role("button", name=self.t("tutorial.open", name=example)).click()
        expect(self.workspace.get_by_role("heading", level=1)).to_have_text(example)
        self.runs()

    def says(self, key: str) -> None:
        """Press a button of the run."""
        self.run_panel.get_by_role("button", name=self.t(key), exact=True).first.click()

    def runs(self) -> None:
        """Press Run, as it is called at the moment."""
        names = [self.t("perform.putBackAndRun"), self.t("perform.again"), self.t("perform.runName", name=".*")]
        name = re.compile(f"^({'|'.join(names)})$")
        self.run_panel.get_by_role("button", name=name).first.click()

    def has_run(self) -> None:
        """Wait until the run of what is open is at its end, and it can be run anew."""
        again = self.run_panel.get_by_role("button", name=self.t("perform.again"))
        back = self.run_panel.get_by_role("button", name=self.t("perform.putBackAndRun"))
        expect(again.or_(back).first).to_be_enabled(timeout=PATIENCE_MS)
        done = self.t("perform.doneAll").partition(":")[0]
        expect(self.run_panel.get_by_text(re.compile(f"{done}: ")).first).to_be_visible(timeout=PATIENCE_MS)

    # -- programs that are there already

    def places_of(self, name: str) -> list[int]:
        """Where an icon of the dictionary stands."""
        words = re.compile(f"^{re.escape(self._words_of(name))}([;,]|$)")
        labels = [step.get_attribute("aria-label") or "" for step in self.steps.all()]
        return [place for place, label in enumerate(labels) if words.match(label)]

    def place_of(self, name: str) -> int:
        """Where it stands alone."""
        (place,) = self.places_of(name)
        return place

    def takes_out(self, first: int, *more: int) -> None:
        """What stands at these places."""
        count = self.steps.count()
        self.step(first).click()
        for place in more:
            self.step(place).click(modifiers=["Control"])
        self.page.keyboard.press("Delete")
        expect(self.steps).to_have_count(count - 1 - len(more))

    def exchanges(self, place: int, name: str) -> None:
        """Another icon in the place of this one, by the menu of the page: select it there, right click it, exchange."""
        self.icon(name).click()
        self.step(place).click(button="right", modifiers=SHIFT)
        words = self.t("upper.exchange").partition(" {")[0]
        self.menu.get_by_role("menuitem", name=re.compile(f"^{re.escape(words)}")).first.click()
        expect(self.step(place)).to_have_attribute("aria-label", re.compile(f"^{re.escape(self._words_of(name))}"))

    def conditions(self, *texts: str) -> None:
        """Of the branch."""
        branch = self.workspace.locator(f"[role=option][aria-label^='{self.t('upper.branch')}']").first
        box = branch.bounding_box()
        assert box
        corner = {"x": box["width"] - 14, "y": box["height"] - 8}  # no flow stands there
        branch.click(button="right", modifiers=SHIFT, position=corner, force=True)
        self.menu.get_by_role("menuitem", name=re.compile(f"^{re.escape(self.t('upper.conditions'))}")).click()
        form = self.page.get_by_role("form", name=self.t("upper.branchTitle"))
        for number, text in enumerate(texts):
            form.get_by_label(self.t("upper.branchElseIf" if number else "upper.branchIf", n=number)).fill(text)
        form.get_by_role("button", name=self.t("upper.ok")).click()
        expect(form).to_have_count(0)

    def _words_of(self, name: str) -> str:
        first = (self.icon(name).get_attribute("title") or "").partition("\n")[0]
        return first.removesuffix(f" ({name})")
