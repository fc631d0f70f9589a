"""The list of licences holds what the packages say, and breaks over no newer version."""

import json

import pytest

import licences
from licences import Package


@pytest.fixture
def repository(tmp_path):
    """Writes a small repository whose project needs these and whose page imports `drawing`."""

    def write(*requirements, locked=None):
        (tmp_path / "docs").mkdir(exist_ok=True)
        lines = ["[project]", f"dependencies = {json.dumps(requirements)}"]
        lines += ["[project.optional-dependencies]", 'dev = ["hypothesis"]']
        (tmp_path / "pyproject.toml").write_text("\n".join(lines))
        source = tmp_path / "browser" / "src" / "view.ts"
        source.parent.mkdir(parents=True, exist_ok=True)
        source.write_text("import { line } from 'drawing/lines'\nimport own from './own'\n")
        packages = {
            "": {"dependencies": {"drawing": "^1"}},
            "node_modules/drawing": {"license": "MIT", "dependencies": {"colours": "^2"}},
            "node_modules/colours": {"license": "ISC"},
            "node_modules/linter": {"license": "GPL-3.0", "dev": True},
        }
        (tmp_path / "browser" / "package-lock.json").write_text(json.dumps({"packages": locked or packages}))
        return tmp_path

    return write


def test_the_list_of_this_repository_is_up_to_date(capsys):
    assert licences.main(["--check"]) == 0, capsys.readouterr().out


def test_what_a_package_needs_in_turn_is_listed_and_what_only_develops_is_not(repository):
    names = {package.name for package in licences.python_packages(repository("starlette>=1"), {})}
    assert {"starlette", "anyio", "idna"} <= names
    assert not {"hypothesis", "pytest"} & names


def test_the_page_lists_what_its_sources_import_and_what_that_needs(repository):
    packages = licences.page_packages(repository())
    assert packages == [Package("colours", "ISC", ("drawing",)), Package("drawing", "MIT")]


def test_a_requirement_of_another_system_or_of_an_extra_nobody_wants_is_left_out():
    requirements = ['colorama; sys_platform == "win32"', 'tests; extra == "dev"', 'old; python_version < "3.11"']
    assert licences.shipped(requirements) == {}


def test_a_requirement_of_one_version_of_python_and_of_a_wanted_extra_is_listed():
    requirements = ['only_for_3_11; python_version < "3.12"', 'fast; extra == "speed"', "Plain[quick]>=1"]
    expected = {"only-for-3-11": frozenset(), "fast": frozenset(), "plain": frozenset({"quick"})}
    assert licences.shipped(requirements, ["speed"]) == expected


def test_a_package_that_is_not_installed_keeps_its_row(repository):
    packages = licences.python_packages(repository("nobody-has-this"), {"nobody-has-this": "ISC"})
    assert packages == [Package("nobody-has-this", "ISC")]


def test_an_unknown_licence_is_told(repository, capsys):
    assert licences.main(["--root", str(repository("nobody-has-this"))]) == 1
    assert "nobody-has-this: its licence is unknown" in capsys.readouterr().out


def test_a_package_that_is_not_listed_is_told_by_the_check_alone(repository, capsys):
    root = repository("starlette>=1")
    assert licences.main(["--root", str(root), "--check"]) == 1
    assert "starlette (BSD-3-Clause) is not listed" in capsys.readouterr().out
    assert not (root / licences.PAGE).exists()
    assert licences.main(["--root", str(root)]) == 0
    assert licences.main(["--root", str(root), "--check"]) == 0


@pytest.mark.parametrize(
    ("installed", "listed", "is_right"),
    [
        ("BSD-3-Clause", "BSD License", True),  # the same, as a newer version says it
        ("MIT", "BSD-3-Clause AND 0BSD AND MIT", True),
        ("0BSD", "BSD License", False),
        ("GPL-3.0-only", "LGPL-3.0-only", False),
        ("MIT AND GPL-2.0", "MIT", False),
        ("Our own", "Our own", True),
        ("Our own", "MIT", False),
    ],
)
def test_a_licence_that_the_list_does_not_name_is_told(installed, listed, is_right):
    assert (not list(licences.complaints([Package("it", installed)], {"it": listed}))) is is_right


def test_a_row_that_is_needed_no_more_is_no_fault():
    assert not list(licences.complaints([Package("it", "MIT")], {"it": "MIT", "formerly": "MIT"}))


def test_a_licence_is_the_expression_or_the_short_word_or_the_classifiers():
    class About(dict):
        def get_all(self, key):
            return ["License :: OSI Approved :: BSD License", "License :: OSI Approved"] if key == "Classifier" else []

    assert licences.licence_of(About({"License-Expression": "MIT", "License": "other"})) == "MIT"
    assert licences.licence_of(About({"License": "ISC"})) == "ISC"
    assert licences.licence_of(About({"License": "Permission is hereby\ngranted"})) == "BSD License"
