"""What a user does with puzzles (requirements G10, H07)."""

from onika.wire.act.act import Act


class ListPuzzles(Act, frozen=True):
    """Which puzzles there are, and how far one is; the value is a `view.PuzzlesView`."""


class BeginPuzzle(Act, frozen=True):
    """Open what a puzzle begins with as a new application, whose runs are judged by it; the value is its id."""

    puzzle: str
    doc: str = ""
    """An application that is open already, to be judged by it; empty: a new one is opened."""
