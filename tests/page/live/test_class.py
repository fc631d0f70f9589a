"""A class in a real browser: two learners in cells of their own, and the board that shows both (X25)."""

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Page, expect

from kit.process.class_process import ClassProcess
from onika.process import confinement

pytestmark = pytest.mark.page

PATIENCE_MS = 90_000


@pytest.fixture
def school(tmp_path) -> Iterator[ClassProcess]:
    words = () if confinement.level() else ("--unconfined",)
    process = ClassProcess(tmp_path, "--seats", "2", "--upper", "--expect", "Q_MEZ[0] > -9", "go_home", *words)
    yield process
    assert process.end() in (0, 130)


def seated(page: Page, school: ClassProcess, name: str) -> Page:
    """A page at the seat of a learner, who comes in by the front."""
    page.goto(school.address)
    page.get_by_label("Code of the class").fill(school.code)
    page.get_by_label("Your name").fill(name)
    page.get_by_role("button", name="Take a seat").click()
    page.get_by_role("link", name="Open my workcell").click()
    expect(page.locator(".strip")).to_contain_text(name, timeout=PATIENCE_MS)
    return page


def test_two_learners_work_each_in_a_cell_of_their_own_and_the_board_shows_and_steers_both(
    school: ClassProcess, new_page: Callable[[], Page]
) -> None:  # R-X25
    board = new_page()
    board.context.add_cookies(
        [{"name": name, "value": value, "url": school.address} for name, value in school.teacher.cookies.items()]
    )
    board.goto(f"{school.address}board")
    expect(board.locator(".empty")).to_contain_text(school.code)
    ana, ben = (seated(new_page(), school, name) for name in ("Ana", "Ben"))
    row_of_ana, row_of_ben = (board.locator(f"tr[data-seat='{seat}']") for seat in (1, 2))

    ana.get_by_role("button", name="Run go_home").click()
    expect(row_of_ana).to_contain_text("ran to its end 1/1", timeout=PATIENCE_MS)
    expect(row_of_ben).to_contain_text("not run yet")

    row_of_ben.get_by_role("checkbox").check()
    board.get_by_role("button", name="Freeze", exact=True).click()
    expect(ben.locator(".strip")).to_contain_text("Your teacher has frozen all this")
    expect(ana.locator(".strip.works")).to_be_visible()
    board.get_by_label("Message to learners").fill("Look up")
    board.get_by_role("button", name="Send").click()
    expect(ben.locator(".note")).to_contain_text("Look up")
    expect(ana.locator(".note")).to_have_count(0)

    ana.get_by_role("button", name="Hand in").click()
    expect(row_of_ana.locator("summary")).to_have_text("1 of 1 hold", timeout=PATIENCE_MS)
    expect(ana.locator(".strip")).to_contain_text("1 of 1 expectations hold")

    with board.expect_popup() as opened:
        row_of_ana.get_by_role("link", name="Watch").click()
    watching = opened.value
    expect(watching.locator(".strip")).to_contain_text("You watch Ana", timeout=PATIENCE_MS)
    row_of_ana.get_by_role("button", name="Take").click()
    expect(watching.locator(".strip")).to_contain_text("You work at the seat of Ana")
    expect(ana.locator(".strip")).to_contain_text("Your teacher works here")
    watching.close()


def test_who_comes_back_to_a_seat_that_had_ended_is_told_why_the_workcell_stands_as_at_first(
    school: ClassProcess, new_page: Callable[[], Page]
) -> None:  # R-X25
    ana = seated(new_page(), school, "Ana")
    expect(ana.locator(".strip .note")).to_have_count(0)
    ana.goto(school.address)  # her page is closed
    school.teacher.wish("restart", school.seat("Ana"))
    school.teacher.until(lambda rows: rows["Ana"]["process"] == "off")
    ana.get_by_role("link", name="Open my workcell").click()
    note = ana.locator(".strip .note")
    expect(note).to_contain_text("Your seat began anew: the teacher has ended it.", timeout=PATIENCE_MS)
    expect(note).to_contain_text("the workcell stands as at the beginning")
    note.get_by_role("button").click()
    expect(note).to_have_count(0)
