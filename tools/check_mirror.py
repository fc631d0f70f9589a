"""Tests mirror the house: every src/onika/A/B.py has its tests/A/test_B.py, and the other way round.

What is much to say of one file may stand apart by subject, in tests/A/test_B_SUBJECT.py beside its tests/A/test_B.py.

Usage: python tools/check_mirror.py [ROOT]. Prints what is missing and ends with 1 if anything is.
"""

import sys
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

UNMIRRORED_SOURCES = {
    "labs": "data, loaded by path like any user's; tests/contract reads every module of it",
}
"""Folders of src/onika whose files need no test of their own, and why."""

UNMIRRORED_TESTS = {
    "contract": "one rule over all members of a kind",
    "labs": "what single modules do; they are no part of the package",
    "model/rules/independent": "a second reading of the rules, which shares no code with them",
    "kit_tests": "mirrors tests/kit/, not src/",
    "oracle_tests": "mirrors tests/oracle/, not src/",
    "journey": "the three journeys of the house, whole",
    "page": "the page in a real Chromium, served by the real program",
    "play": "stories of the engine",
    "site": "real programs and processes",
    "tools": "mirrors tools/, not src/",
}
"""Folders of tests whose files belong to no single source file, and why."""

TESTED_AS_ONE = {
    "wire": "messages are data; tests/contract/test_messages.py tries each, a test of a file what its decoder refuses",
}
"""Folders of src/onika whose files have a test of their own only where they do something, and why."""

WITHOUT_TEST: dict[str, str] = {}
"""Source files (A/B.py) that no test file of their own can say anything of, and why."""


def complaints(root: Path) -> Iterator[str]:
    """What breaks the mirror under `root`: missing tests, orphaned tests, exceptions that no longer hold."""
    sources = {path: _test_of(path) for path in _files(root / "src" / "onika", UNMIRRORED_SOURCES)}
    tests = {path for path in _files(root / "tests", UNMIRRORED_TESTS) if path.name.startswith("test_")}
    for source, test in sources.items():
        excepted = str(source) in WITHOUT_TEST
        if test not in tests and not excepted and not any(map(source.is_relative_to, TESTED_AS_ONE)):
            yield f"src/onika/{source} has no tests/{test}"
        if test in tests and excepted:
            yield f"src/onika/{source} has its test: strike it from WITHOUT_TEST"
    for test in sorted(tests - set(sources.values())):
        if any(test.parent == one.parent and test.stem.startswith(f"{one.stem}_") for one in sources.values()):
            continue
        yield f"tests/{test} tests no src/onika/{test.parent / test.name.removeprefix('test_')}"
    for gone in sorted(set(WITHOUT_TEST) - {str(source) for source in sources}):
        yield f"src/onika/{gone} is gone: strike it from WITHOUT_TEST"


def _files(folder: Path, left_out: dict[str, str]) -> list[PurePosixPath]:
    """The Python files below, but for package markers and what is left out, relative and in order."""
    paths = sorted(PurePosixPath(path.relative_to(folder)) for path in folder.rglob("*.py"))
    return [path for path in paths if path.name != "__init__.py" and not any(map(path.is_relative_to, left_out))]


def _test_of(source: PurePosixPath) -> PurePosixPath:
    return source.with_name(f"test_{source.stem.strip('_')}.py")


def main(root: Path) -> int:
    """Print every complaint; 1 if there is any."""
    found = list(complaints(root))
    for complaint in found:
        print(complaint)
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[1]))
