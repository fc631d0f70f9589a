"""Lists under which licences stand the packages that Onika brings along, in docs/licences.md.

Usage: python tools/licences.py [--check] [--root ROOT]. Python's packages are those that pyproject.toml asks for and
all that these need in turn on Linux, as the metadata of what is installed says; what only develops is not among them.
The page's are those that its sources import, and all that these need in turn, as browser/package-lock.json says. With
--check nothing is written, and the tool ends with 1 where a package is not in the list, stands under a licence that
the list does not name, or names none. No version is listed: a newer one breaks nothing while its licence is the same.
"""

import argparse
import json
import re
import sys
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[1]
PAGE = "docs/licences.md"
UNKNOWN = "unknown"
PYTHONS = ("3.11", "3.12", "3.13", "3.14")
"""Versions for which the markers of requirements are looked at: what one of them needs is listed."""

_HEADER = """# Licences of what Onika brings along

Onika itself stands under the [Apache License 2.0](../LICENSE). These are the packages that come with it, and those that
they need in turn; what only builds and tests is not among them. `python tools/licences.py` writes this page from what
the packages say of themselves, and `make check` compares.

"""
_SECTIONS = {
    "python": ("Installed with it, from PyPI", "on Linux; each is a package of its own, with its licence beside it"),
    "page": (
        "In the built page, from npm",
        "with all that they need by the lock file, some of it at build time only",
    ),
}
_FAMILIES = ("MIT", "BSD", "0BSD", "Apache", "PSF", "MPL", "ISC", "Zlib", "CC0", "Unlicense", "LGPL", "AGPL", "GPL")
_FAMILY = re.compile(rf"(?<![A-Za-z0-9])({'|'.join(_FAMILIES)})(?![a-z])", re.IGNORECASE)
_ROW = re.compile(r"^\| `([^`]+)` \| ([^|]+) \| ([^|]*) \|$", re.MULTILINE)
_IMPORT = re.compile(r"""(?:from|import)\s*\(?\s*['"]((?:@[^/'"]+/)?[^./'"$][^/'"]*)""")
_SOURCES = (".ts", ".svelte", ".js")
_LONGEST = 60


@dataclass(frozen=True)
class Package:
    """A package with its licence, and who needs it: the names of packages, none for one that Onika itself needs."""

    name: str
    licence: str
    needed_by: tuple[str, ...] = ()

    @property
    def families(self) -> set[str]:
        """The licences without their numbers; the whole text where none of them is well known."""
        families = {family.upper() for family in _FAMILY.findall(self.licence)}
        return families or {self.licence}


def python_packages(root: Path, listed: Mapping[str, str]) -> list[Package]:
    """What the base installation needs; of what is not installed here the licence that is listed stands."""

    def needs_of(name: str) -> Iterable[str]:
        try:
            return metadata.distribution(name).requires or ()
        except metadata.PackageNotFoundError:
            return ()

    def licence(name: str) -> str:
        try:
            return licence_of(metadata.metadata(name))
        except metadata.PackageNotFoundError:
            return listed.get(name, UNKNOWN)

    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return _all_needed(shipped(project["dependencies"]), lambda name, extras: shipped(needs_of(name), extras), licence)


def page_packages(root: Path) -> list[Package]:
    """What the sources of the page import, as the lock file and the packages themselves say."""
    browser = root / "browser"
    locked = json.loads((browser / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    imported = {name for path in _page_sources(browser / "src") for name in _IMPORT.findall(_text(path))}
    begun = {name: frozenset[str]() for name in imported if f"node_modules/{name}" in locked}

    def needs(name: str, _extras: frozenset[str]) -> dict[str, frozenset[str]]:
        return {needed: frozenset() for needed in _locked(locked, name).get("dependencies", {})}

    def licence(name: str) -> str:
        return str(_locked(locked, name).get("license") or _own_licence(browser, name))

    return _all_needed(begun, needs, licence)


def shipped(requirements: Iterable[str], extras: Iterable[str] = ()) -> dict[str, frozenset[str]]:
    """The names with their extras that a list of requirements asks for on Linux, under any Python that will do."""
    names: dict[str, frozenset[str]] = {}
    for text in requirements:
        requirement = Requirement(text)
        if _is_wanted(requirement, ("", *extras)):
            name = canonicalize_name(requirement.name)
            names[name] = names.get(name, frozenset()) | requirement.extras
    return names


def licence_of(about: Any) -> str:
    """What a package says of its licence: the expression, the short word, or the classifiers."""
    word = str(about.get("License-Expression") or about.get("License") or "").strip()
    if word and "\n" not in word and len(word) <= _LONGEST:
        return word
    classifiers = [text for text in about.get_all("Classifier") or () if text.startswith("License ::")]
    names = [text.rsplit(" :: ", 1)[-1] for text in classifiers]
    return " AND ".join(name for name in names if name != "OSI Approved") or UNKNOWN


def page(packages: Mapping[str, Iterable[Package]]) -> str:
    """The whole document."""
    parts = [_HEADER]
    for key, (title, remark) in _SECTIONS.items():
        rows = "".join(f"| `{each.name}` | {each.licence} | {_needed_by(each)} |\n" for each in packages[key])
        parts.append(f"## {title}\n\n{remark[0].upper()}{remark[1:]}.\n\n")
        parts.append(f"| package | licence | needed by |\n|---|---|---|\n{rows}\n")
    return "".join(parts).rstrip() + "\n"


def rows(text: str) -> dict[str, str]:
    """The licences that a document lists, by package."""
    return {name: licence.strip() for name, licence, _ in _ROW.findall(text)}


def complaints(packages: Iterable[Package], listed: Mapping[str, str]) -> Iterator[str]:
    """What the list does not say, or says otherwise. A row too many is none: another version may need less."""
    for package in packages:
        if package.licence == UNKNOWN:
            yield f"{package.name}: its licence is unknown; look at the package itself, or do without it"
        elif package.name not in listed:
            yield f"{package.name} ({package.licence}) is not listed"
        elif package.families - Package(package.name, listed[package.name]).families:
            yield f"{package.name}: stands under {package.licence}, listed is {listed[package.name]}"


def main(words: list[str]) -> int:
    """Write the list, or compare it; 1 where something is to be said."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare only")
    parser.add_argument("--root", type=Path, default=ROOT)
    given = parser.parse_args(words)
    path = given.root / PAGE
    listed = rows(_text(path)) if path.exists() else {}
    packages = {"python": python_packages(given.root, listed), "page": page_packages(given.root)}
    if not given.check:
        path.write_text(page(packages), encoding="utf-8")
        listed = rows(_text(path))
    wrong = list(complaints((each for section in packages.values() for each in section), listed))
    for complaint in wrong:
        print(f"{PAGE}: {complaint}")
    if wrong and given.check:
        print("python tools/licences.py writes the list anew")
    return 1 if wrong else 0


def _all_needed(
    begun: Mapping[str, frozenset[str]],
    needs: Callable[[str, frozenset[str]], Mapping[str, frozenset[str]]],
    licence: Callable[[str], str],
) -> list[Package]:
    """From those that are needed to begin with to all, by name."""
    extras_of = dict(begun)
    needed_by: dict[str, set[str]] = {name: set() for name in begun}
    waiting = list(begun)
    while waiting:
        name = waiting.pop()
        for needed, extras in needs(name, extras_of[name]).items():
            needed_by.setdefault(needed, set()).add(name)
            former = extras_of.get(needed)
            if former is None or extras - former:
                extras_of[needed] = extras | (former or frozenset())
                waiting.append(needed)
    direct = {name: needed_by[name] if name not in begun else set() for name in needed_by}
    return [Package(name, licence(name), tuple(sorted(direct[name]))) for name in sorted(direct)]


def _is_wanted(requirement: Requirement, extras: Iterable[str]) -> bool:
    if requirement.marker is None:
        return True
    platform = {"sys_platform": "linux", "platform_system": "Linux", "os_name": "posix", "platform_machine": "x86_64"}
    pythons = [{"python_version": python, "python_full_version": f"{python}.0"} for python in PYTHONS]
    situations = [{**platform, **python, "extra": extra} for python in pythons for extra in extras]
    return any(requirement.marker.evaluate(situation) for situation in situations)


def _locked(locked: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    about: Mapping[str, Any] = locked.get(f"node_modules/{name}", {})
    return about


def _own_licence(browser: Path, name: str) -> str:
    path = browser / "node_modules" / name / "package.json"
    return str(json.loads(_text(path)).get("license") or UNKNOWN) if path.is_file() else UNKNOWN


def _page_sources(folder: Path) -> Iterator[Path]:
    return (path for path in sorted(folder.rglob("*")) if path.suffix in _SOURCES)


def _needed_by(package: Package) -> str:
    return ", ".join(f"`{name}`" for name in package.needed_by) or "Onika"


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
