"""A puzzle where it stands, with its programs: an application by name, or a text in the words of AL beside it.

Requirements G10, H07.
"""

from dataclasses import dataclass
from pathlib import Path

from onika.desk.plan.application_text import Converted, convert
from onika.files import text
from onika.files.al import reader
from onika.model.puzzle import Puzzle
from onika.store.base_directory import BaseDirectory
from onika.store.site import Site
from onika.words.fault import Fault, Place
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class PlacedPuzzle:
    """A puzzle in a base directory."""

    puzzle: Puzzle
    base: BaseDirectory

    @property
    def path(self) -> Path:
        """Its file."""
        return self.base.puzzle_file(self.puzzle.name)

    def program(self, name: str, site: Site) -> Converted:
        """The application that `PROGRAM` or `SOLUTION` names, or what is wrong with it."""
        home = site.at(self.base.path)
        path = self._path_of(name, home)
        if path is None or not path.is_file():
            place = Place(str(self.path), self._line_of(name))
            fault = Fault(place, Reason.of("desk.no_program_of_puzzle", name=name), Reason.of("desk.puzzle_not_set"))
            return Converted(None, "", (fault,))
        return convert(path, None, home)

    def faults(self, site: Site) -> tuple[Fault, ...]:
        """What is wrong with its programs."""
        names = dict.fromkeys(filter(None, (self.puzzle.program, self.puzzle.solution)))
        return tuple(fault for name in names for fault in self.program(name, site).faults)

    def _path_of(self, name: str, home: Site) -> Path | None:
        if not name.endswith(reader.ENDING):
            return home.application_file(name) if Path(name).name == name else None
        return self.path.parent / name if Path(name).name == name else None

    def _line_of(self, name: str) -> int:
        content, _ = text.load(self.path, str(self.path))
        lines = enumerate((content or "").splitlines(), start=1)
        return next((number for number, line in lines if line.split()[1:] == [name]), 0)


def placed_puzzles(site: Site) -> tuple[PlacedPuzzle, ...]:
    """Every puzzle of the search path that can be read, easiest first; of one name the first one counts."""
    puzzles: dict[str, PlacedPuzzle] = {}
    for base in site.directories:
        for name in base.puzzles:
            puzzle, _ = base.puzzle(name)
            if puzzle is not None:
                puzzles.setdefault(name, PlacedPuzzle(puzzle, base))
    return tuple(sorted(puzzles.values(), key=lambda placed: (placed.puzzle.level, placed.puzzle.name)))


def placed_puzzle(name: str, site: Site) -> PlacedPuzzle | None:
    """The puzzle of this name; None: there is none that can be read."""
    return next((placed for placed in placed_puzzles(site) if placed.puzzle.name == name), None)
