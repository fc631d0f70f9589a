from onika.model.puzzle import Puzzle

PUZZLE = Puzzle("p", (("en", "P"),), (("en", "Do it"),), ("LAMP == 1",), actions=5, seconds=7.0)


def test_a_goal_that_is_reached_is_worth_a_star_and_brevity_and_speed_one_more_each():  # R-G10
    assert PUZZLE.stars(5, 7.0) == 3
    assert PUZZLE.stars(6, 7.0) == 2
    assert PUZZLE.stars(5, 7.1) == 2
    assert PUZZLE.stars(6, 7.1) == 1


def test_what_nobody_counts_costs_no_star():  # R-G10
    plain = Puzzle("p", (("en", "P"),), (("en", "Do it"),), ("LAMP == 1",))
    assert plain.stars(1000, 1000.0) == 3


def test_a_puzzle_with_a_program_to_begin_with_is_one_of_mending():  # R-H07
    assert not PUZZLE.is_fault
    assert Puzzle("p", (), (), ("LAMP == 1",), program="broken.al").is_fault
