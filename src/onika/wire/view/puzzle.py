"""Puzzles as a page shows them, and what came of a run that was to solve one (requirements G10, H07)."""

from msgspec import field

from onika.wire.view.view import View
from onika.words.reason import NOTHING, Reason


class GoalView(View, frozen=True):
    """A condition, and whether it held at the end of a run."""

    text: str
    is_met: bool = False
    found: str = ""
    """The value then; empty: there was none."""


class GoalWordsView(View, frozen=True):
    """What so many conditions, one after the other, mean for people."""

    conditions: int
    words: dict[str, str] = field(default_factory=dict)
    """By language."""


class PuzzleResultView(View, frozen=True):
    """What came of a run of an application that was begun for a puzzle."""

    puzzle: str
    goals: tuple[GoalView, ...] = ()
    is_solved: bool = False
    """Whether all goals were met, by the program alone."""
    uncounted: Reason = NOTHING
    """Why the run does not count, whatever was met."""
    stars: int = 0
    actions: int = 0
    """How many the program has."""
    took_s: float = 0.0


class BestView(View, frozen=True):
    """The best result of a puzzle on this machine."""

    stars: int
    actions: int
    took_s: float


class PuzzleView(View, frozen=True):
    """A puzzle of the search path."""

    name: str
    level: int
    titles: dict[str, str] = field(default_factory=dict)
    """By language, as the other words."""
    tasks: dict[str, str] = field(default_factory=dict)
    goals: tuple[str, ...] = ()
    goal_words: tuple[GoalWordsView, ...] = ()
    """What they mean, from the first one on."""
    is_fault: bool = False
    """Whether it begins with a program that is to be mended."""
    actions: int = 0
    seconds: float = 0.0
    hints: tuple[dict[str, str], ...] = ()
    tries: int = 0
    best: BestView | None = None


class PuzzlesView(View, frozen=True):
    """All puzzles, easiest first."""

    puzzles: tuple[PuzzleView, ...] = ()
