import pytest

from onika.link.link_events import LinkStateChanged
from onika.link.link_terms import LinkTerms
from onika.link.liveness import Liveness
from onika.link.lost import LossCause
from onika.link.state import LinkEvent, LinkState
from onika.wire.packet import Beat

TERMS = LinkTerms(beat_ns=10, suspect_ns=30, lost_ns=100, greeting_ns=200)


def linked(terms=TERMS):
    happenings = []
    pulse = Liveness(terms, happenings)
    pulse.opened(0)
    pulse.greeted(0)
    happenings.clear()
    return pulse, happenings


def test_silence_makes_a_link_suspect_first_and_lost_later():  # R-F01
    pulse, happenings = linked()
    assert pulse.listen(29) is None
    assert happenings == []
    assert pulse.listen(30) is None
    assert happenings == [LinkStateChanged(LinkState.SUSPECT)]
    assert pulse.listen(99) is None
    why = pulse.listen(100)
    assert why is not None
    assert why.cause is LossCause.SILENT


def test_a_word_clears_the_suspicion():
    pulse, happenings = linked()
    pulse.listen(50)
    pulse.note_arrival(51)
    assert happenings == [LinkStateChanged(LinkState.SUSPECT), LinkStateChanged(LinkState.LINKED)]
    assert pulse.listen(80) is None
    assert pulse.state is LinkState.LINKED


def test_a_greeting_that_takes_too_long_is_given_up():
    pulse = Liveness(TERMS, [])
    pulse.opened(1000)
    assert pulse.listen(1199) is None
    assert pulse.listen(1200) is not None


def test_beats_come_at_their_rate_and_missed_ones_are_not_made_up_for():
    pulse, _ = linked()
    assert [pulse.beat(at) for at in (0, 5, 10, 55, 60, 65)] == [
        Beat(1, 0),
        None,
        Beat(2, 10),
        Beat(3, 55),
        None,
        Beat(4, 65),
    ]


def test_nobody_beats_before_the_greeting():
    pulse = Liveness(TERMS, [])
    pulse.opened(0)
    assert pulse.beat(50) is None


@pytest.mark.parametrize(
    ("now_ns", "due_ns"),
    [(0, 10), (7, 3), (12, 0)],
)
def test_a_linked_end_is_due_for_its_next_beat(now_ns, due_ns):
    pulse, _ = linked()
    pulse.beat(0)
    assert pulse.due_ns(now_ns, may_retry=False) == due_ns


def test_without_beats_an_end_is_due_when_silence_changes_something():
    pulse, _ = linked(LinkTerms(beat_ns=0, suspect_ns=30, lost_ns=100))
    assert pulse.due_ns(10, may_retry=False) == 20
    pulse.listen(30)
    assert pulse.due_ns(40, may_retry=False) == 60


def test_without_beats_and_thresholds_nothing_is_ever_due():  # law 15
    pulse, happenings = linked(LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=0))
    assert pulse.due_ns(10, may_retry=True) is None
    assert pulse.listen(10**15) is None
    assert pulse.beat(10**15) is None
    assert happenings == []


def test_something_to_say_again_is_due_after_the_retry_time():
    pulse, _ = linked(LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=0, retry_ns=25))
    assert pulse.due_ns(10, may_retry=True) == 25
    assert pulse.due_ns(10, may_retry=False) is None


def test_an_end_without_connection_is_never_due():
    pulse, happenings = linked()
    pulse.turn(LinkEvent.CUT)
    assert pulse.due_ns(10, may_retry=True) is None
    assert happenings == [LinkStateChanged(LinkState.APART)]
    assert not pulse.is_linked
