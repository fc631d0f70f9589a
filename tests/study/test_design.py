"""A balanced order of subjects."""

from collections import Counter

from hypothesis import given, strategies as st

from onika.study.design import order

VARIANTS = ("pictures", "both", "words")


def test_24_subjects_are_eight_of_each_and_of_every_three_each_gets_another():  # R-H03
    dealt = order(VARIANTS, 24, 1994)
    assert Counter(variant for _, variant in dealt) == dict.fromkeys(VARIANTS, 8)
    assert all({variant for _, variant in dealt[i : i + 3]} == set(VARIANTS) for i in range(0, 24, 3))
    assert [name for name, _ in dealt][:2] == ["s01", "s02"]


def test_the_same_seed_deals_the_same_on_every_machine_and_another_another():  # R-H03
    first = [variant for _, variant in order(VARIANTS, 6, 1994)]
    assert first == [variant for _, variant in order(VARIANTS, 6, 1994)]
    assert first == ["pictures", "both", "words", "both", "words", "pictures"]
    assert order(VARIANTS, 24, 1994) != order(VARIANTS, 24, 1995)


def test_every_order_of_a_block_comes_up_equally_often():  # R-H03
    firsts = Counter(tuple(variant for _, variant in order(VARIANTS, 3, seed)) for seed in range(1200))
    assert len(firsts) == 6
    assert min(firsts.values()) > 150


@given(st.integers(2, 6), st.integers(1, 60), st.integers(0, 99))
def test_groups_never_differ_by_more_than_one(variants, subjects, seed):  # R-H03
    names = [str(number) for number in range(variants)]
    counts = Counter(variant for _, variant in order(names, subjects, seed))
    assert max(counts[name] for name in names) - min(counts[name] for name in names) <= 1
