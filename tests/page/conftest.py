"""A real Chromium, pages of it that tolerate no error, and the program that they show."""

import os
import re
import shutil
from collections.abc import Callable, Generator, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Error, Page, expect, sync_playwright

from kit.labs.laboratory import Laboratory
from kit.labs.small_tasks import small_laboratory

from .person import Person
from .program import Program

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


STARTED: list[Program] = []
"""The programs of the file of tests that is tried."""


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Notes that a test has failed: nobody knows what it has left behind in the programs that it saw."""
    report = yield
    if report.failed:
        for program in STARTED:
            program.is_doubtful = True
    return report


@pytest.fixture(scope="module")
def begin(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., Program]]:
    """Starts programs: `begin("jmoveC", "--no-connect")`; words that begin with a dash are options."""

    def started_with(*words: str, folder: Path | None = None, command: tuple[str, ...] = ("page",)) -> Program:
        where = folder or tmp_path_factory.mktemp("onika")
        files = tuple(word for word in words if not word.startswith("-"))
        program = Program(where, files, tuple(word for word in words if word.startswith("-")), command)
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
