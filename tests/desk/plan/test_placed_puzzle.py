from dataclasses import replace

import pytest

from onika.desk.plan.placed_puzzle import PlacedPuzzle, placed_puzzle, placed_puzzles
from onika.files.puzzles.puzzle import write
from onika.model.puzzle import Puzzle
from onika.store.base_directory import BaseDirectory
from onika.store.site import open_site

SITE = open_site([], {}, None)
PUZZLE = Puzzle("mine", (("en", "Mine"),), (("en", "Do it."),), ("LAMP == 1",), level=9)
HOME = "BEGIN\n  DRIVE jmoveC TO home\nEND\n"


def placed(folder, **changes):
    (folder / "puzzle").mkdir(exist_ok=True)
    puzzle = replace(PUZZLE, **changes)
    (folder / "puzzle" / "mine.puzzle").write_text(write(puzzle))
    return PlacedPuzzle(puzzle, BaseDirectory(folder))


def test_a_text_beside_the_puzzle_is_a_program_of_it(tmp_path):  # R-G10
    puzzle = placed(tmp_path, program="broken.al")
    (tmp_path / "puzzle" / "broken.al").write_text(HOME)
    application = puzzle.program("broken.al", SITE).application
    assert application is not None and application.name == "broken"
    assert puzzle.faults(SITE) == ()


def test_an_application_of_the_search_path_is_a_program_by_its_name(tmp_path):  # R-G10
    application = placed(tmp_path, solution="assemble").program("assemble", SITE).application
    assert application is not None and application.name == "assemble"


@pytest.mark.parametrize("name", ["absent.al", "nothing_of_it", "../puzzle/broken.al", "/etc/passwd"])
def test_a_program_that_is_not_there_is_told_with_its_line(tmp_path, name):  # R-B07
    puzzle = placed(tmp_path, solution=name)
    (tmp_path / "puzzle" / "broken.al").write_text(HOME)
    fault = puzzle.faults(SITE)[0]
    assert fault.reason.key == "desk.no_program_of_puzzle"
    assert puzzle.path.read_text().splitlines()[fault.place.line - 1].split() == ["SOLUTION", name]


def test_what_is_wrong_with_a_text_is_told(tmp_path):  # R-B07
    puzzle = placed(tmp_path, program="broken.al")
    (tmp_path / "puzzle" / "broken.al").write_text("BEGIN\n  DRIVE nothingC\nEND\n")
    assert puzzle.faults(SITE)


def test_puzzles_of_ones_own_stand_among_the_others_and_before_those_of_the_same_name(tmp_path):  # R-G10
    mine = placed(tmp_path)
    (tmp_path / "puzzle" / "climb.puzzle").write_text(write(PUZZLE))
    (tmp_path / "puzzle" / "unreadable.puzzle").write_text("nonsense")
    site = open_site([tmp_path], {}, None)
    names = [found.puzzle.name for found in placed_puzzles(site)]
    assert "mine" in names and "unreadable" not in names and names.count("climb") == 1
    climb = placed_puzzle("climb", site)
    assert climb is not None and climb.base.path == tmp_path
    assert placed_puzzle("mine", site) == mine
