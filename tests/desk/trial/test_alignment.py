from onika.desk.trial.alignment import Pair, align, job

WAY = ["open", "move a", "line b", "close"]


def both(*numbers):
    return [Pair(*number) for number in numbers]


def test_equal_ways_are_paired_one_by_one():  # R-X07
    assert align(WAY, WAY) == both((0, 0), (1, 1), (2, 2), (3, 3))


def test_what_is_missing_and_what_is_new_stands_alone():  # R-X07
    assert align(WAY, ["open", "line b", "close"]) == both((0, 0), (1, None), (2, 1), (3, 2))
    assert align(WAY, ["open", "open", *WAY[1:]]).count(Pair(None, 0)) == 1


def test_exchanged_actions_are_one_missing_and_one_new():  # R-X07
    pairs = align(WAY, ["open", "line b", "move a", "close"])
    assert sum(pair.done is None for pair in pairs) == sum(pair.kept is None for pair in pairs) == 1


def test_another_target_of_the_same_job_is_the_same_action_and_another_job_is_not():  # R-X07
    assert align(WAY, ["open", "move c", "line b", "close"])[1] == Pair(1, 1)
    assert Pair(1, None) in align(WAY, ["open", "jump a", "line b", "close"])
    assert job("move a b") == "move"
