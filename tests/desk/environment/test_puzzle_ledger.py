from dataclasses import replace

import pytest

from onika.desk.environment.file.puzzles import SCORES
from onika.desk.environment.puzzle_ledger import PuzzleLedger
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.run import begun
from onika.desk.environment.state.model import Model
from onika.desk.plan.preparation import prepare_run
from onika.files.puzzles.scores import PuzzleScore, PuzzleScores
from onika.store.site import open_site
from onika.wire.view import PuzzleResultView
from onika.words.reason import Reason

PLAN = prepare_run("go_home", open_site([], {}, None)).plan
GOING = begun("a1", PLAN, 1, 0.0, StepMembership({}, {}))
SOLVED = PuzzleResultView("climb", (), True, stars=3, actions=3, took_s=5.4)


@pytest.fixture
def said():
    return []


@pytest.fixture
def ledger(tmp_path, said):
    return PuzzleLedger(tmp_path, said.append)


def after(result):
    return Model(run=GOING.shown(state="over", puzzle=result))


def test_a_run_that_has_just_ended_is_noted_once(ledger, tmp_path):  # R-G10
    ledger.follow(Model(run=GOING), after(SOLVED))
    ledger.follow(after(SOLVED), replace(after(SOLVED), people=2))
    assert PuzzleScores(tmp_path / SCORES).all() == {"climb": PuzzleScore(1, 3, 3, 5.4)}


def test_what_does_not_count_and_what_is_for_no_puzzle_is_not_noted(ledger, tmp_path):  # R-G10
    uncounted = PuzzleResultView("climb", uncounted=Reason.of("run.puzzle_not_put_back"))
    ledger.follow(Model(run=GOING), after(uncounted))
    ledger.follow(Model(run=GOING), after(None))
    assert PuzzleScores(tmp_path / SCORES).all() == {}


def test_a_score_that_cannot_be_written_is_told(tmp_path, said):  # R-G10
    PuzzleLedger(tmp_path / "absent", said.append).follow(Model(run=GOING), after(SOLVED))
    assert [say.level for say in said] == ["warning"]
