"""An arm that is really blocked: what stopped is told in the words of the program, and put right by one press."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, joints, target

pytestmark = pytest.mark.page

ABOVE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)
"""Above the box with the triangle."""
ON_IT = "0.0 0.0 -1.0 0.0 1.0 0.0 0.7 0.28 -0.3346"
"""Where a hand takes it that is open; one that is shut comes no further than its lid."""
INSIDER = re.compile(r"ctraj|jtraj|puma|TAU_|LawBroken|ModuleError")
LONGEST_MS = 20_000


@pytest.fixture
def program(begin, tmp_path_factory):
    """With a runtime in wall time, and a program whose hand was never opened."""
    folder = tmp_path_factory.mktemp("onika")
    above = [job("jmoveC", "Joint job"), joints("above", *ABOVE, duration=2.0)]
    down = [job("cmoveC", "Cartesian job"), target("on_it", "Cartesian object", ON_IT, "1.4")]
    Laboratory(folder / "home" / "onika").application("shut", [*above, *down, job("opengripC")])
    return begin("shut", "--upper", "--rtpu=rt0", folder=folder)


@pytest.mark.slow  # where the machine keeps the arm silent first, it takes a minute
def test_a_blocked_arm_is_told_in_the_words_of_the_program_and_one_press_begins_anew(program, page):  # R-X06, law 18
    program.enter(page)
    run = page.get_by_role("region", name="Run", exact=True)
    run.get_by_role("button", name=re.compile("^Run")).click()
    stop = page.get_by_role("dialog", name=re.compile("something is in the way"))
    expect(stop).to_contain_text("The hand touches the box with the triangle.", timeout=LONGEST_MS)
    expect(stop).to_contain_text(re.compile(r"The hand stands at x = 70\.\d cm, y = 28\.\d cm, z = -29\.\d cm\."))
    expect(stop).to_contain_text("“a job: a target” could not go on.")
    for plain in (stop.get_by_role("heading"), stop.get_by_role("group").first.locator(".text")):
        expect(plain).not_to_contain_text(INSIDER)
    details = stop.locator("details")
    expect(details.get_by_text("ctraj").first).to_be_hidden()
    details.locator("summary").click()
    expect(details.get_by_text("ctraj").first).to_be_visible()
    expect(details).to_contain_text(re.compile(r"The hand did not come to its target: it stands \d\.\d cm away"))

    stop.get_by_role("button", name=re.compile("Put the workcell back and run again")).click()
    expect(stop).to_have_count(0)
    expect(run).to_contain_text(re.compile(r"action 1 of 3|1 of 3"))
    expect(stop).to_contain_text("The hand touches the box with the triangle.", timeout=LONGEST_MS)
    stop.get_by_role("button", name=re.compile("End the run")).click()
    expect(run.get_by_text("Ended early")).to_be_visible(timeout=LONGEST_MS)
