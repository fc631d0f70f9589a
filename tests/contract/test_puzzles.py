"""Shipped puzzles are fair: solutions reach the goal, what does nothing does not, and planted faults show themselves.

The programs are carried out in virtual time, as `onika run` does it.
"""

import pytest

from kit.desk.scripted_runtime import KeepingWatcher
from onika.desk.plan.application_text import convert, keep
from onika.desk.plan.placed_puzzle import placed_puzzle, placed_puzzles
from onika.desk.run.run import run
from onika.desk.run.settings import RunSettings
from onika.store.site import open_site
from onika.words.condition import Condition
from onika.words.sentence import LANGUAGES

SITE = open_site([], {}, None)
PUZZLES = {placed.puzzle.name: placed for placed in placed_puzzles(SITE)}
FAULTS = [name for name, placed in PUZZLES.items() if placed.puzzle.is_fault]

SHOWN = {
    "open_hole": ("refused", "a hole, step 4 of flow 0"),
    "empty_hand": ("completed", "GRIP_MEZ[0] < 0.08"),
    "shut_hand": ("aborted", "the hand did not come to its target"),
    "out_of_reach": ("refused", "joint 3 at 4.20 rad is beyond 3.93"),
    "ten_steps": ("aborted", "joint 5 would stand at"),
    "one_step": ("completed", "X_MEZ[2,3] > 0.1"),
    "wrong_way": ("completed", "Q_MEZ[0] > 0.75"),
    "swapped_flows": ("completed", "GRIP_MEZ[0] < 0.08"),
    "borrowed_arm": ("refused", "task puma claims it too"),
    "waving": ("completed", "GRIP_MEZ[0] > 0.07"),
    "crossed_tags": ("refused", "waits at hands"),
    "no_waiting": ("aborted", "the arm did not come to its target"),
}
"""How each planted fault shows itself: how the run ends, and what is said then, or a condition that does not hold."""

NOTHING = """\
BEGIN
  NOP noop
END
"""


def outcome_of(path, puzzle):
    conditions = tuple(map(Condition.parse, puzzle.expectations))
    settings = RunSettings(str(path), is_virtual=True, with_fifo=False, has_black_box=False, expectations=conditions)
    return run(settings, SITE, KeepingWatcher())


def program(name, placed, folder):
    """A program of a puzzle as a file."""
    converted = placed.program(name, SITE)
    assert converted.application is not None, converted.faults
    if not name.endswith(".al"):
        return SITE.application_file(name)
    path = folder / f"{placed.puzzle.name}.appl"
    assert keep(converted, path, overwrites=False) is None
    return path


def said(outcome):
    """What is told of a run that went wrong."""
    unmet = [condition.text for condition, _, holds in outcome.expectations if not holds]
    cause = [str(outcome.result.cause)] if outcome.result is not None and outcome.result.cause else []
    return [*(str(fault.sentence) for fault in outcome.faults), *cause, *unmet]


def test_there_are_puzzles_of_growing_difficulty_and_twelve_planted_faults():  # R-G10, R-H07
    levels = [placed.puzzle.level for placed in PUZZLES.values() if not placed.puzzle.is_fault]
    assert len(levels) >= 6 and levels == sorted(levels) and len(set(levels)) >= 6
    assert sorted(FAULTS) == sorted(SHOWN)


@pytest.mark.parametrize("name", PUZZLES)
def test_a_puzzle_says_in_every_language_what_is_to_be_done_and_has_hints_and_a_solution(name):  # R-G10, R-G09
    puzzle = PUZZLES[name].puzzle
    for words in (puzzle.titles, puzzle.tasks, *puzzle.hints):
        assert {language for language, _ in words} == set(LANGUAGES)
    assert len(puzzle.hints) >= 2 and puzzle.solution
    assert PUZZLES[name].faults(SITE) == ()


@pytest.mark.site
@pytest.mark.usefixtures("warm_runtimes")
@pytest.mark.parametrize("name", PUZZLES)
def test_the_solution_of_a_puzzle_reaches_its_goal(name, tmp_path):  # R-G10, R-H07
    placed = PUZZLES[name]
    outcome = outcome_of(program(placed.puzzle.solution, placed, tmp_path), placed.puzzle)
    assert outcome.exit_code == 0, said(outcome)
    assert placed.puzzle.stars(outcome.actions, outcome.result.runtime_s) == 3


@pytest.mark.site
@pytest.mark.usefixtures("warm_runtimes")
@pytest.mark.parametrize("name", [name for name in PUZZLES if name not in FAULTS])
def test_a_program_that_does_nothing_does_not_reach_the_goal(name, tmp_path):  # R-G10
    (tmp_path / "idle.al").write_text(NOTHING)
    (tmp_path / "appl").mkdir()
    path = tmp_path / "appl" / "idle.appl"
    assert keep(convert(tmp_path / "idle.al", path, SITE), path, overwrites=False) is None
    outcome = outcome_of(path, PUZZLES[name].puzzle)
    assert outcome.exit_code != 0


@pytest.mark.site
@pytest.mark.usefixtures("warm_runtimes")
@pytest.mark.parametrize("name", FAULTS)
def test_a_planted_fault_shows_itself_in_what_the_run_says(name, tmp_path):  # R-H07
    placed = PUZZLES[name]
    state, words = SHOWN[name]
    outcome = outcome_of(program(placed.puzzle.program, placed, tmp_path), placed.puzzle)
    assert outcome.state == state, said(outcome)
    assert outcome.exit_code != 0
    assert any(words in sentence for sentence in said(outcome)), said(outcome)


def test_a_puzzle_is_found_by_its_name():  # R-G10
    assert placed_puzzle("light_the_lamp", SITE) == PUZZLES["light_the_lamp"]
    assert placed_puzzle("nothing_of_it", SITE) is None
