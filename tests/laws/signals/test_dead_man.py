"""A dead-man switch over a line that may break: it lets go by itself, and nothing begins by itself."""

from hypothesis import given, strategies as st

from onika.laws.signals.dead_man import LOST_S, DeadMan

DT = 0.01


def looked(switch, pieces):
    """What it says at each look; a piece is held or not, None where nothing came."""
    count, held, answers = 0.0, False, []
    for piece in pieces:
        if piece is not None:
            count, held = count + 1.0, piece
        answers.append(switch.is_held(count, held, DT))
    return answers


def test_it_counts_while_news_come_and_until_the_patience_is_over():  # R-K07
    answers = looked(DeadMan(0.12, 0.0), [False, True, *[None] * 14])
    assert answers == [False, *[True] * 12, *[False] * 3]


def test_who_holds_it_already_has_to_let_go_first():  # R-K07
    switch = DeadMan(0.12, 0.0)
    assert looked(switch, [True] * 5) == [False] * 5
    assert looked(switch, [False, True]) == [False, True]


def test_after_a_short_gap_it_counts_again_after_a_long_one_it_is_let_go_first():  # R-K07
    short, long = [None] * 50, [None] * round(LOST_S / DT + 1)
    assert looked(DeadMan(0.12, 0.0), [False, True, *short, True])[-1] is True
    assert looked(DeadMan(0.12, 0.0), [False, True, *long, True, True])[-2:] == [False, False]
    assert looked(DeadMan(0.12, 0.0), [False, True, *long, True, False, True])[-3:] == [False, False, True]


def test_what_is_said_again_is_no_news():
    switch = DeadMan(0.12, 7.0)
    assert not any(switch.is_held(7.0, True, DT) for _ in range(200))


@given(st.lists(st.sampled_from([True, False, None]), max_size=300))
def test_whenever_it_counts_it_was_held_within_the_patience_and_let_go_before(pieces):  # R-K07
    for at, is_held in enumerate(looked(DeadMan(0.12, 0.0), pieces)):
        if is_held:
            last = max(k for k in range(at + 1) if pieces[k] is not None)
            assert pieces[last] is True
            assert (at - last) * DT < 0.12
            assert False in pieces[:last]
