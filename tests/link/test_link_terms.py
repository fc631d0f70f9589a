import pytest

from onika.link.link_terms import CHILD, LOCAL, NO_BEATS
from onika.wire.frame import FRAME_LIMIT


@pytest.mark.parametrize("terms", [LOCAL, CHILD])
def test_several_beats_may_be_missed_before_a_link_is_suspect_and_more_before_it_is_lost(terms):
    assert terms.beat_ns * 3 < terms.suspect_ns < terms.lost_ns


def test_in_virtual_time_nobody_is_ever_late():  # law 15
    assert (NO_BEATS.beat_ns, NO_BEATS.suspect_ns, NO_BEATS.lost_ns, NO_BEATS.reading_age_ns) == (0, 0, 0, 0)


@pytest.mark.parametrize("terms", [LOCAL, CHILD, NO_BEATS])
def test_everything_that_is_not_split_fits_a_frame(terms):
    assert max(terms.single, terms.piece) + 1024 <= FRAME_LIMIT
