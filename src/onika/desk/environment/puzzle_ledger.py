"""Writes down how runs that were to solve puzzles have ended (requirement G10)."""

from collections.abc import Callable
from pathlib import Path

from onika.desk.environment.file.puzzles import SCORES
from onika.desk.environment.state.model import Model
from onika.files.puzzles.scores import PuzzleScores
from onika.wire import page


class PuzzleLedger:
    """Follows an environment; `say` is told where nothing can be written down."""

    def __init__(self, state: Path, say: Callable[[page.Say], None]) -> None:
        self._scores = PuzzleScores(state / SCORES)
        self._say = say

    def follow(self, before: Model, after: Model) -> None:
        """Note every run that has just ended, as far as it counts."""
        if before.run is after.run and before.beside is after.beside:
            return
        noted = {run.view.number for run in before.every_run if run.view.puzzle is not None}
        for run in after.every_run:
            result = run.view.puzzle
            if result is None or run.view.number in noted or result.uncounted:
                continue
            refusal = self._scores.note(result.puzzle, result.stars, result.actions, result.took_s)
            if refusal is not None:
                self._say(page.Say("warning", refusal.reason, run.doc))
