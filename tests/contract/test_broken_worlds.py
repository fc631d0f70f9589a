"""Worlds that are files, broken at every line: each fault has its place, and whoever opens them lives (X19)."""

import random
from pathlib import PurePath

import numpy as np
import pytest

from onika.files import robot as robot_file, world as world_file
from onika.store.shipped import shipped_directories
from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.wire.world_source import WorldFile, WorldSource, digest_of
from onika.words.reason import reason_of
from onika.workcell.filmed.filmed_world import FilmedWorld, judged

SAMPLES = 10
"""Broken lines that are tried of each shipped world in every run; all of them are tried by the long tests."""

WAYS = ("delete", "double", "garble", "reverse", "cut")
NAMING = ("FILE", "TOOL", "ROBOTS", "WHEN")
"""Keywords whose first word has to be somewhere."""

TEXTS = (world_file.ENDING, robot_file.ENDING)
NAMES = sorted(path.stem for lab in shipped_directories() for path in (lab / "world").glob(f"*{world_file.ENDING}"))


def source_of(world):
    source, faults = gather_world(world, open_site((), {}, None))
    assert source is not None and faults == ()
    return source


def broken(line, way):
    """What becomes of a line."""
    match way:
        case "delete":
            return ""
        case "double":
            return f"{line}\n{line}"
        case "garble":
            return line[: len(line) // 2] + "%&\\x" + line[len(line) // 2 + 2 :]
        case "reverse":
            return " ".join(reversed(line.split()))
    return line[: len(line) // 2]


def variants(source):
    """Every line of every text and model of a world, in every way."""
    for number, file in enumerate(source.files):
        if PurePath(file.name).suffix not in (*TEXTS, ".xml"):
            continue
        lines = file.content.decode().split("\n")
        for at, line in enumerate(lines):
            if line.strip():
                yield from ((number, at, way) for way in WAYS)


def with_broken(source, number, at, way):
    """The files of a world with one line broken."""
    file = source.files[number]
    lines = file.content.decode().split("\n")
    lines[at] = broken(lines[at], way)
    changed = WorldFile(file.name, file.path, "\n".join(lines).encode())
    files = (*source.files[:number], changed, *source.files[number + 1 :])
    return WorldSource(source.world, digest_of(files), files)


def tell_and_live(files, is_stepped=False):
    """What is wrong has a place; what can be opened moves; else there is a reason why not."""
    faults = judged(files)
    paths = {file.path for file in files.files} | {file.name for file in files.files}
    for fault in faults:
        assert fault.place.file in paths
        assert fault.reason.text and fault.instead.text
        assert fault.place.line or fault.instead.key == "files.world_left_out"
    try:
        world = FilmedWorld(files)
    except ValueError as wrong:
        assert faults and reason_of(wrong).text
        return
    if is_stepped:
        live(world)


def live(world):
    """It steps, its devices are claimed, and what it consists of can be drawn."""
    world.watch_mishaps()
    for epoch, sheet in enumerate(world.devices(), start=1):
        try:
            world.claim(sheet.name, epoch)
        except ValueError as wrong:
            assert reason_of(wrong).text
    world.step(40_000_000)
    assert np.isfinite(world.poses()).all()
    assert len(world.scene()) > 0
    assert all(reason.text for reason in (*world.places(), *world.standing()))
    world.take_mishaps()
    world.reset()
    world.step(world.now_ns + 10_000_000)


@pytest.mark.parametrize("name", NAMES)
def test_a_line_that_is_broken_somewhere_is_told_with_its_place(name):  # R-X19
    source = source_of(name)
    for number, at, way in random.Random(11).sample([*variants(source)], SAMPLES):
        tell_and_live(with_broken(source, number, at, way))


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_every_line_that_is_broken_is_told_and_whoever_opens_the_world_lives(name):  # R-X19
    source = source_of(name)
    for number, at, way in variants(source):
        tell_and_live(with_broken(source, number, at, way), is_stepped=True)


@pytest.mark.parametrize("name", NAMES)
def test_a_name_that_is_nowhere_is_told_with_its_line(name):  # R-X19
    source = source_of(name)
    for number, file in enumerate(source.files):
        if PurePath(file.name).suffix not in TEXTS:
            continue
        for at, line in enumerate(file.content.decode().split("\n")):
            keyword, *words = line.split() or [""]
            if keyword not in NAMING:
                continue
            name = next(word for word in words if word != "-")
            lines = file.content.decode().split("\n")
            lines[at] = line.replace(name, "x_y_z", 1)
            lost = "\n".join(lines).encode()
            files = (*source.files[:number], WorldFile(file.name, file.path, lost), *source.files[number + 1 :])
            faults = judged(WorldSource(source.world, digest_of(files), files))
            assert (file.path, at + 1) in {(fault.place.file, fault.place.line) for fault in faults}, line
