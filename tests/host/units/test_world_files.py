import importlib

import pytest

from kit.worlds.installed_world import install_world
from onika.host.units.world_files import WorldFiles, source_files
from onika.host.units.world_registry import module_of

SECOND = 1_000_000_000


class Cell:
    """A world of two files, which is looked at once a second."""

    def __init__(self, folder):
        self.code, self.model = folder / "cell.py", folder / "cell.xml"
        self.code.write_text("ARMS = 1\n")
        self.model.write_text("<cell/>\n")
        self.files = WorldFiles({"cell": (self.code, self.model), "other": ()}.__getitem__)
        self.second = 0
        self.look()

    def look(self, worlds=("cell", "other"), later_ns=SECOND):
        self.second += later_ns
        return [(told.world, told.is_outdated, told.text.key) for told in self.files.look(worlds, self.second, 7.0)]


@pytest.fixture
def cell(tmp_path):
    return Cell(tmp_path)


CHANGED, BACK = ("cell", True, "host.world_outdated"), ("cell", False, "host.world_as_loaded")


def test_a_file_that_another_editor_changes_is_told_once(cell):  # law 21
    assert cell.look() == []
    cell.model.write_text("<cell arms='2'/>\n")
    assert cell.look() == [CHANGED]
    cell.code.write_text("ARMS = 2\n")
    assert cell.look() == cell.look() == []


def test_the_file_is_named_with_the_time(cell):  # law 21
    cell.code.write_text("ARMS = 2\n")
    (told,) = cell.files.look(("cell",), 2 * SECOND, 7.0)
    assert str(cell.code) in str(told.text) and told.at_s == 7.0


def test_what_is_put_back_is_told_too(cell):  # law 21
    cell.code.write_text("ARMS = 2\n")
    assert cell.look() == [CHANGED]
    cell.code.write_text("ARMS = 1\n")
    assert cell.look() == [BACK]
    cell.code.write_text("ARMS = 3\n")
    assert cell.look() == [CHANGED]


def test_a_file_that_is_written_anew_with_the_same_text_has_not_changed(cell):
    cell.code.unlink()
    cell.code.write_text("ARMS = 1\n")
    assert cell.look() == []


def test_a_file_that_is_removed_has_changed(cell):
    cell.code.unlink()
    assert cell.look() == [CHANGED]


def test_between_two_seconds_nothing_is_looked_at(cell):
    cell.code.write_text("ARMS = 2\n")
    assert cell.look(later_ns=SECOND // 2) == []
    assert cell.look(later_ns=SECOND // 2) == [CHANGED]


def test_a_world_counts_from_its_opening_on(tmp_path):
    cell = Cell(tmp_path)
    cell.files = WorldFiles(lambda _world: (cell.code,))
    assert cell.look(()) == []
    cell.code.write_text("ARMS = 2\n")
    assert cell.look(("cell",)) == []
    cell.code.write_text("ARMS = 3\n")
    assert cell.look(("cell",)) == [CHANGED]


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package whose code must not be executed, and a lone module that offers a world."""
    monkeypatch.syspath_prepend(tmp_path)
    folder = tmp_path / "plant_of_test" / "halls"
    folder.mkdir(parents=True)
    for path in (folder.parent / "__init__.py", folder / "__init__.py", folder / "north.py", folder / "cell.py"):
        path.write_text("raise SystemExit('executed')\n")
    for name in ("cell.xml", "readme.txt"):
        (folder / name).write_text("x")
    install_world(tmp_path, "lone", "raise SystemExit('executed')\n")
    importlib.invalidate_caches()
    return folder


def test_the_files_of_a_world_are_found_without_executing_any(package):
    names = {path.name for path in source_files("plant_of_test.halls.north")}
    assert names == {"__init__.py", "north.py", "cell.py", "cell.xml"}
    assert (
        source_files(module_of("lone"))
        == source_files(module_of("lone@2"))
        == (package.parents[1] / "lone_of_test.py",)
    )


@pytest.mark.parametrize("module", ["", "nowhere", "plant_of_test.nowhere.north", "json.nowhere", "sys", "sys.north"])
def test_of_what_is_not_there_or_has_no_file_nothing_is_watched(package, module):
    assert source_files(module) == ()
