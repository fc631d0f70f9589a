"""A real Chromium, pages of it that tolerate no error, and the program that they show."""

import contextlib
import os
import queue
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Generator, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Error, Locator, Page, expect, sync_playwright

from kit.labs.laboratory import Laboratory
from kit.labs.small_tasks import small_laboratory

expect.set_options(timeout=10_000)

FLAGS = (
    "--no-sandbox",  # the tests run as root in a container
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)

NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
"""What it is called on Debian (without windows it costs half the time of a processor), elsewhere, and by Google."""

SETTLED = "() => new Promise(done => setTimeout(done))"
"""Ends after all the page has thrown so far was told; a rejected promise is told of one turn late."""


@pytest.fixture(scope="package")
def chromium() -> Iterator[Browser]:
    """One Chromium for all tests of the page."""
    path = next(filter(None, map(shutil.which, NAMES)), None)
    if not path and os.environ.get("CI"):
        pytest.fail("There is no Chromium on the PATH, and under CI the page must be tried.")
    if not path:
        pytest.skip("There is no Chromium on the PATH.")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        yield browser
        browser.close()


@pytest.fixture
def excused() -> list[str]:
    """Patterns of the errors that a test brings about on purpose; it adds them before they happen."""
    return []


@pytest.fixture
def new_page(chromium: Browser, excused: list[str]) -> Iterator[Callable[[], Page]]:
    """Opens pages, each as another person's browser would be; in the end none may have met an error."""
    errors: list[str] = []
    pages: list[Page] = []

    def note_console(message: ConsoleMessage) -> None:
        if message.type == "error":
            errors.append(f"{message.text} ({message.location['url']}:{message.location['lineNumber']})")

    def thrown(error: Error) -> None:
        errors.append(error.stack or error.message)

    def opened() -> Page:
        page = chromium.new_context(viewport={"width": 1440, "height": 900}).new_page()
        page.on("console", note_console)
        page.on("pageerror", thrown)
        pages.append(page)
        return page

    yield opened
    for page in pages:
        if not page.is_closed():
            page.evaluate(SETTLED)
        page.context.close()
    unexcused = [error for error in errors if not any(re.search(pattern, error) for pattern in excused)]
    assert not unexcused, "errors in the page:\n" + "\n".join(unexcused)


@pytest.fixture
def page(new_page: Callable[[], Page]) -> Page:
    """An empty page of 1440 by 900."""
    return new_page()


STARTED: list["Program"] = []
"""The programs of the file of tests that is tried."""


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Notes that a test has failed: nobody knows what it has left behind in the programs that it saw."""
    report = yield
    if report.failed:
        for program in STARTED:
            program.is_doubtful = True
    return report


class Program:
    """The environment as a process, with a home, a state and a base directory of its own."""

    def __init__(self, folder: Path, files: tuple[str, ...], options: tuple[str, ...]) -> None:
        self.home, self.state = folder / "home", folder / "state"
        self.home.mkdir(parents=True, exist_ok=True)
        self._home_at_first = Path(tempfile.mkdtemp(dir=folder)) / "home"
        shutil.copytree(self.home, self._home_at_first, symlinks=True)
        self._files, self._options = files, options
        self.said: list[str] = []
        self.is_doubtful = False
        """Whether a test has failed meanwhile."""
        self._start()

    def _start(self) -> None:
        self._is_ended = False
        self._keys: queue.Queue[str] = queue.Queue()
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("ONIKA_")}
        self.process = subprocess.Popen(
            [sys.executable, "-c", "from onika.cli import main; main()", "page", *self._files, "--port", "0",
             "--no-browser", *self._options],
            env={**inherited, "HOME": str(self.home), "XDG_STATE_HOME": str(self.state)},
            cwd=self.home.parent, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
        )  # fmt: skip
        self._reading = threading.Thread(target=self._read)
        self._reading.start()

    def _begin_anew(self) -> None:
        """As at first: a test that is tried again must not meet what its first try has left behind."""
        self.kill()
        for folder in (self.home, self.state):
            shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self._home_at_first, self.home, symlinks=True)
        self.is_doubtful = False
        self._start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.said.append(line)
            for address in re.findall(r"http://\S+key=\S+", line):
                self._keys.put(address)

    def address(self) -> str:
        """The address that lets the next browser in."""
        try:
            return self._keys.get(timeout=60)
        except queue.Empty:
            raise AssertionError(f"no address was printed: {''.join(self.said)}") from None

    def enter(self, page: Page) -> Page:
        """Let a browser in, and wait until it is shown what is open."""
        if self.is_doubtful:
            self._begin_anew()
        page.goto(self.address())
        expect(page.get_by_role("navigation").get_by_role("listitem")).not_to_have_count(0)
        return page

    def end(self) -> None:
        """Ctrl-C; it must end by itself."""
        self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(30)
        finally:
            self.kill()

    def kill(self) -> None:
        """An end that it learns nothing of."""
        if not self._is_ended:
            self._is_ended = True
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait(30)
            self._reading.join(30)
            assert self.process.stdout is not None
            self.process.stdout.close()


@pytest.fixture(scope="module")
def begin(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., Program]]:
    """Starts programs: `begin("jmoveC", "--no-connect")`; words that begin with a dash are options."""

    def started_with(*words: str, folder: Path | None = None) -> Program:
        where = folder or tmp_path_factory.mktemp("onika")
        files = tuple(word for word in words if not word.startswith("-"))
        program = Program(where, files, tuple(word for word in words if word.startswith("-")))
        STARTED.append(program)
        return program

    yield started_with
    started = [*STARTED]
    STARTED.clear()
    for program in started:
        if program.process.poll() is None:
            program.end()
        program.kill()
    complaints = ["".join(program.said) for program in started if "Traceback" in "".join(program.said)]
    assert not complaints, "\n".join(complaints)


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Laboratory:
    """A base directory of small tasks, and two configurations of two of them."""
    return small_laboratory(tmp_path_factory.mktemp("base") / "bench")


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


@pytest.fixture(scope="module")
def program(begin: Callable[..., Program], lab: Laboratory) -> Program:
    """The environment with the laboratory of small tasks, unconnected; one for all tests of a file."""
    return begin(f"--base={lab.path}", "--no-connect")


@pytest.fixture
def people() -> Callable[[Page], Person]:
    """Makes a person of a page."""
    return Person


@pytest.fixture
def me(program: Program, page: Page) -> Person:
    """A person with a blank configuration in front, and the small tasks in the library."""
    person = Person(program.enter(page))
    person.blank()
    person.libraries("bench")
    return person
