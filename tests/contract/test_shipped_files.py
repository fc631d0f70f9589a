"""One rule for all files that ship: no fault, and damage to them is reported (R-B07, R-B08)."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from onika.files import appl, conf, onk, picture, rmod, robot, syntax, world
from onika.files.puzzles import puzzle
from onika.model.syntax import Syntax
from onika.store.shipped import shipped, shipped_directories
from onika.store.site import open_site
from onika.words.fault import Fault

FOLDERS = ("module", "conf", "dict", "appl", "robot", "world", "puzzle")
LINES = 10
"""At so many of each file; `test_formats` does so at every line of the small ones that it draws."""


def shipped_files() -> list[Path]:
    folders = [base / folder for base in shipped_directories() for folder in FOLDERS]
    paths = [path for folder in (*folders, shipped() / "prefs") for path in sorted(folder.glob("*"))]
    endings = (".rmod", ".conf", ".onk", ".appl", ".dta", ".robot", ".world", ".puzzle")
    return [path for path in paths if path.suffix in endings]


def reader(path: Path, types: Syntax) -> Callable[[str], tuple[Any, tuple[Fault, ...]]]:
    name = path.stem
    if path.name.endswith(syntax.NAME):
        return lambda text: syntax.read(text, name, path.name)
    return {
        ".rmod": lambda text: rmod.read(text, name, path.name),
        ".conf": lambda text: conf.read(text, name, path.name),
        ".onk": lambda text: onk.read(text, name, path.name, types),
        ".appl": lambda text: appl.read(text, name, path.name, types),
        ".dta": lambda text: picture.read(text, name, path.name),
        ".puzzle": lambda text: puzzle.read(text, name, path.name),
        ".robot": lambda text: robot.read(text, name, path.name),
        ".world": lambda text: world.read(text, name, path.name),
    }[path.suffix]


def writer(path: Path) -> Callable[[Any], str]:
    if path.name.endswith(syntax.NAME):
        return syntax.write
    formats = {
        ".rmod": rmod,
        ".conf": conf,
        ".onk": onk,
        ".appl": appl,
        ".dta": picture,
        ".puzzle": puzzle,
        ".robot": robot,
        ".world": world,
    }
    return formats[path.suffix].write  # type: ignore[attr-defined]


def every_shipped_file() -> Iterator[tuple[Path, str, Callable[[str], tuple[Any, tuple[Fault, ...]]]]]:
    types, faults = open_site([], {}, None).syntax()
    assert types is not None and faults == ()
    for path in shipped_files():
        yield path, path.read_text("utf-8"), reader(path, types)


def test_every_shipped_file_is_without_fault_and_keeps_its_meaning() -> None:
    for path, text, read in every_shipped_file():  # R-B08
        record, faults = read(text)
        assert faults == (), path
        again, faults = read(writer(path)(record))
        assert faults == ()
        assert writer(path)(again) == writer(path)(record), path
        if path.suffix == ".rmod":
            assert writer(path)(record) == text
        else:
            assert again == record


def test_every_shipped_file_cut_or_garbled_at_a_line_is_reported_or_means_the_same() -> None:
    for number, (path, text, read) in enumerate(every_shipped_file()):  # R-B07
        lines = text.splitlines(keepends=True)
        record, _ = read(text)
        end = next((at for at, line in enumerate(lines) if line.strip() == "EOF"), len(lines) - 1)
        step = max(1, len(lines) // LINES)  # elsewhere in every file: of a kind there are many, and they are alike
        for at in {0, *range(number % step, end + 1, step), end}:
            assert read("".join(lines[:at]))[1], f"{path} cut before line {at + 1}"
            garbled, faults = read("".join([*lines[:at], "?? garbled ??\n", *lines[at + 1 :]]))
            is_comment = not lines[at].strip() or lines[at].lstrip().startswith("#")
            assert faults or (is_comment and garbled == record), f"{path}:{at + 1} garbled"
