from onika.files.puzzles.scores import PuzzleScore, PuzzleScores


def test_the_best_result_stays_and_every_try_counts(tmp_path):  # R-G10
    scores = PuzzleScores(tmp_path / "puzzles")
    assert scores.all() == {}
    for stars, actions, took_s in ((0, 3, 5.0), (1, 9, 9.0), (3, 5, 7.0), (2, 1, 1.0), (3, 5, 6.5), (0, 1, 1.0)):
        assert scores.note("light", stars, actions, took_s) is None
    assert PuzzleScores(tmp_path / "puzzles").all() == {"light": PuzzleScore(6, 3, 5, 6.5)}


def test_what_was_not_solved_has_tries_and_no_stars():  # R-G10
    assert PuzzleScore().after(0, 1, 1.0) == PuzzleScore(1)
    assert PuzzleScore(1).after(2, 4, 8.0) == PuzzleScore(2, 2, 4, 8.0)


def test_with_equal_stars_fewer_actions_are_better_then_less_time():  # R-G10
    best = PuzzleScore(1, 2, 5, 7.0)
    assert best.after(2, 4, 9.0) == PuzzleScore(2, 2, 4, 9.0)
    assert best.after(2, 5, 6.0) == PuzzleScore(2, 2, 5, 6.0)
    assert best.after(2, 6, 1.0) == PuzzleScore(2, 2, 5, 7.0)


def test_a_file_that_is_none_has_no_scores_and_one_that_cannot_be_written_is_told(tmp_path):  # R-B07
    path = tmp_path / "puzzles"
    path.write_text("{")
    assert PuzzleScores(path).all() == {}
    assert PuzzleScores(tmp_path / "absent" / "puzzles").note("light", 1, 1, 1.0) is not None
