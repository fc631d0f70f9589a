"""The browser that all other tests of the page rest upon."""

import os
import re
import subprocess
import sys

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def test_a_page_is_drawn_and_found_by_role_and_name(page):
    page.goto("data:text/html,<button>Stop</button>")
    expect(page.get_by_role("button", name="Stop")).to_be_visible()
    assert page.viewport_size == {"width": 1440, "height": 900}


def test_two_pages_are_two_persons_browsers(page, new_page):
    assert new_page().context != page.context


def test_an_error_that_was_announced_is_excused(page, excused):
    excused.append("brought about")
    page.goto("data:text/html,<script>console.error('brought about'); throw Error('brought about')</script>")


def test_an_error_in_the_page_fails_its_test(chromium, tmp_path):
    scripts = ("console.error('amiss')", "throw Error('amiss')", "Promise.reject(Error('amiss'))", "'nothing amiss'")
    address = "data:text/html,<link rel=icon href=data:,><script>{0}</script>"
    tests = (f"def test_{i}(page): page.goto({address.format(script)!r})\n" for i, script in enumerate(scripts))
    (tmp_path / "test_amiss.py").write_text("".join(tests))
    (tmp_path / "conftest.py").write_text("from page.conftest import *\n")
    words = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path)]
    search = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}  # the copied fixtures use the kit
    output = subprocess.run(words, cwd=tmp_path, env=search, capture_output=True, text=True, check=False).stdout
    assert "4 passed, 3 errors" in output, output
    assert re.findall(r"ERROR test_amiss.py::test_(\d) - AssertionError: errors in the page", output) == ["0", "1", "2"]
