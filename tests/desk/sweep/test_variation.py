import pytest
from hypothesis import given, strategies as st

from onika.desk.sweep.variation import Variation


def test_a_range_gives_values_within_it_and_a_list_its_own():  # R-X23
    drawn = [Variation.parse("pd.STIFF=0.5..2").draw(seed) for seed in range(200)]
    assert 0.5 <= min(drawn) < 0.6
    assert 1.9 < max(drawn) <= 2.0
    assert {Variation.parse("pd.STIFF=1,2,5").draw(seed) for seed in range(50)} == {1.0, 2.0, 5.0}
    assert Variation.parse("pd.STIFF=3").draw(7) == 3.0


def test_what_is_drawn_follows_from_seed_and_name_alone():  # R-X23
    variation = Variation.parse("pd.STIFF=0..1")
    assert variation.draw(3) == variation.draw(3) == Variation.parse("pd.STIFF=0..1").draw(3)
    assert variation.draw(3) != variation.draw(4)
    assert variation.draw(3) != Variation.parse("pd.DAMP=0..1").draw(3)


@pytest.mark.parametrize(
    "text", ["pd.STIFF", "pd.STIFF=", "STIFF=1", "pd.STIFF=a..b", "pd.STIFF=2..1", "pd.STIFF=1..inf", "pd.STIFF=nan"]
)
def test_what_is_none_is_refused(text):  # R-X23
    with pytest.raises(ValueError, match=r"expected (TASK|a range)"):
        Variation.parse(text)


@given(st.floats(-1e9, 1e9), st.floats(-1e9, 1e9))
def test_it_is_written_as_it_is_read(one, other):  # R-X23
    text = f"pd.STIFF={min(one, other):.15g}..{max(one, other):.15g}"
    assert Variation.parse(text).text == text
    assert Variation.parse("pd.STIFF=1,2.5").text == "pd.STIFF=1,2.5"
