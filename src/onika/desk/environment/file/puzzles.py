"""Puzzles: which there are and how far one is, and how one is begun (requirements G10, H07)."""

from dataclasses import replace

from onika.desk.environment.file.applications import open_program
from onika.desk.environment.outcome.on_file import closed, is_running
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.desk.plan.placed_puzzle import PlacedPuzzle, placed_puzzle, placed_puzzles
from onika.files.puzzles.scores import PuzzleScore, PuzzleScores
from onika.model.application import AppFlow, Application
from onika.model.puzzle import Puzzle
from onika.wire import act
from onika.wire.view import BestView, GoalWordsView, PuzzlesView, PuzzleView
from onika.words.reason import Reason

SCORES = "puzzles"
"""The file of scores in the directory of what outlives a session."""


def list_puzzles(model: Model, _asked: act.ListPuzzles, outside: Services) -> Done:
    """All of the search path; the value is a `view.PuzzlesView`."""
    scores = PuzzleScores(outside.state / SCORES).all() if outside.state is not None else {}
    puzzles = (placed.puzzle for placed in placed_puzzles(outside.site))
    views = tuple(_view(puzzle, scores.get(puzzle.name, PuzzleScore())) for puzzle in puzzles)
    return Done(model, value=PuzzlesView(views))


def begin_puzzle(model: Model, command: act.BeginPuzzle, outside: Services) -> Done | No:
    """Open what it begins with; the value is the id of the application."""
    placed = placed_puzzle(command.puzzle, outside.site)
    if placed is None:
        return No(Reason.of("run.no_puzzle", name=command.puzzle))
    if command.doc:
        return _judged_by(model, command)
    application = _beginning(placed, outside)
    if isinstance(application, No):
        return application
    return open_program(model, application, placed.puzzle.name)


def _judged_by(model: Model, command: act.BeginPuzzle) -> Done | No:
    opened = model.applications.get(command.doc)
    if opened is None:
        return closed(DocumentKind.APPLICATION)
    if is_running(model, opened.id):
        return No(Reason.of("run.runs_already", name=opened.name))
    return Done(model.with_application(replace(opened, puzzle=command.puzzle)), value=opened.id)


def _beginning(placed: PlacedPuzzle, outside: Services) -> Application | No:
    puzzle = placed.puzzle
    if not puzzle.is_fault:
        return Application(puzzle.name, False, (AppFlow(()),))
    converted = placed.program(puzzle.program, outside.site)
    if converted.application is None:
        return No(converted.faults[0].sentence)
    return replace(converted.application, name=puzzle.name)


def _view(puzzle: Puzzle, score: PuzzleScore) -> PuzzleView:
    return PuzzleView(
        name=puzzle.name,
        level=puzzle.level,
        titles=dict(puzzle.titles),
        tasks=dict(puzzle.tasks),
        goals=puzzle.expectations,
        goal_words=tuple(GoalWordsView(goal.conditions, dict(goal.words)) for goal in puzzle.goals),
        is_fault=puzzle.is_fault,
        actions=puzzle.actions,
        seconds=puzzle.seconds,
        hints=tuple(map(dict, puzzle.hints)),
        tries=score.tries,
        best=BestView(score.stars, score.actions, score.took_s) if score.stars else None,
    )
