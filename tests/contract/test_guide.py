"""The guide is run: its files are written, its Python executed, its commands carried out, page by page."""

import os
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import pytest

from onika.cli import main
from onika.files import buttons, preferences

ROOT = Path(__file__).parents[2]
GUIDE = ROOT / "docs" / "guide"
PAGES = sorted(GUIDE.glob("*.md"))
BLOCK = re.compile(r"^```(\w*)(?: file=(\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Block:
    """A block of code: its language, the file it is, its text and the line where it begins."""

    language: str
    file: str
    text: str
    line: int


def blocks(page):
    text = page.read_text()
    for match in BLOCK.finditer(text):
        yield Block(match[1], match[2] or "", match[3], text.count("\n", 0, match.start()) + 2)


def carry_out(command, folder, capsys):
    """A line of a shell block; `onika` and `python` are those of this test, a run or a check happens within it."""
    name, *rest = shlex.split(command)
    if name == "onika" and rest and rest[0] in ("run", "check", "text"):
        assert main(rest) == 0, f"{command}\n{capsys.readouterr()}"
        return
    words = {"onika": [sys.executable, "-c", "from onika.cli import main; raise SystemExit(main())"]}
    ran = subprocess.run(
        [*words.get(name, [sys.executable]), *rest],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(ROOT / "src")},
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert ran.returncode == 0, f"{command}\n{ran.stdout}{ran.stderr}"


def prepared(folder):
    """A base directory with the modules of the pages before, which later pages build on."""
    for name in ("module", "conf", "dict", "appl", "tests"):
        (folder / name).mkdir()
    for page in PAGES:
        for block in blocks(page):
            if block.file in ("module/wave.py", "module/wait.py", "module/wait.rmod"):
                (folder / block.file).write_text(block.text)


@pytest.mark.site
@pytest.mark.usefixtures("warm_runtimes")
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_what_a_page_says_works(page, tmp_path, monkeypatch, capsys):
    prepared(tmp_path)
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    names = {"__name__": page.stem}
    for block in blocks(page):
        if block.file:
            (tmp_path / block.file).parent.mkdir(exist_ok=True)
            (tmp_path / block.file).write_text(block.text)
        elif block.language == "python":
            # the line numbers of the page, so that a failure names the line to mend
            exec(compile("\n" * (block.line - 1) + block.text, str(page), "exec"), names)
        elif block.language == "sh":
            for command in block.text.splitlines():
                carry_out(command, tmp_path, capsys)


def test_every_page_leads_to_pages_that_exist():
    for page in PAGES:
        for target in re.findall(r"\]\(([^)#]+)\)", page.read_text()):
            assert (page.parent / target).exists(), f"{page.name}: {target}"


def test_every_page_but_the_last_leads_to_the_next_one():
    for page, following in pairwise(PAGES):
        assert f"({following.name})" in page.read_text().splitlines()[-1]


def test_the_preferences_and_buttons_of_the_guide_read_without_fault():
    files = {block.file: block.text for page in PAGES for block in blocks(page) if block.file.startswith(".onika")}
    assert preferences.read(files[".onika"], ".onika", "guide")[1] == ()
    assert buttons.read(files[".onika.buttons"], ".onika.buttons", "guide")[1] == ()


def test_modules_of_the_guide_import_the_front_door_only():
    for page in PAGES:
        for block in blocks(page):
            if block.file.startswith("module/") and block.file.endswith(".py"):
                imported = re.findall(r"^(?:from|import) (onika\S*)", block.text, re.MULTILINE)
                assert imported == ["onika.module"]
