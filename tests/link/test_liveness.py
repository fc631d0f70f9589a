import pytest

from onika.link.link_events import LinkStateChanged
from onika.link.link_terms import LinkTerms
from onika.link.liveness import Liveness
from onika.link.lost import LossCause
from onika.link.state import LinkEvent, LinkState
from onika.wire.packet import Beat

TERMS = LinkTerms(beat_ns=10, suspect_ns=30, lost_ns=100, greeting_ns=200)


def linked(terms=TERMS):
    notices = []
    liveness = Liveness(terms, notices)
    liveness.opened(0)
    liveness.greeted(0)
    notices.clear()
    return liveness, notices


def test_silence_makes_a_link_suspect_first_and_lost_later():  # R-F01
    liveness, notices = linked()
    assert liveness.listen(29) is None
    assert notices == []
    assert liveness.listen(30) is None
    assert notices == [LinkStateChanged(LinkState.SUSPECT)]
    assert liveness.listen(99) is None
    why = liveness.listen(100)
    assert why is not None
    assert why.cause is LossCause.SILENT


def test_a_word_clears_the_suspicion():
    liveness, notices = linked()
    liveness.listen(50)
    liveness.note_arrival(51)
    assert notices == [LinkStateChanged(LinkState.SUSPECT), LinkStateChanged(LinkState.LINKED)]
    assert liveness.listen(80) is None
    assert liveness.state is LinkState.LINKED


def test_a_greeting_that_takes_too_long_is_given_up():
    liveness = Liveness(TERMS, [])
    liveness.opened(1000)
    assert liveness.listen(1199) is None
    assert liveness.listen(1200) is not None


def test_beats_come_at_their_rate_and_missed_ones_are_not_made_up_for():
    liveness, _ = linked()
    assert [liveness.beat(at) for at in (0, 5, 10, 55, 60, 65)] == [
        Beat(1, 0),
        None,
        Beat(2, 10),
        Beat(3, 55),
        None,
        Beat(4, 65),
    ]


def test_nobody_beats_before_the_greeting():
    liveness = Liveness(TERMS, [])
    liveness.opened(0)
    assert liveness.beat(50) is None


@pytest.mark.parametrize(
    ("now_ns", "due_ns"),
    [(0, 10), (7, 3), (12, 0)],
)
def test_a_linked_end_is_due_for_its_next_beat(now_ns, due_ns):
    liveness, _ = linked()
    liveness.beat(0)
    assert liveness.due_ns(now_ns, may_retry=False) == due_ns


def test_without_beats_an_end_is_due_when_silence_changes_something():
    liveness, _ = linked(LinkTerms(beat_ns=0, suspect_ns=30, lost_ns=100))
    assert liveness.due_ns(10, may_retry=False) == 20
    liveness.listen(30)
    assert liveness.due_ns(40, may_retry=False) == 60


def test_without_beats_and_thresholds_nothing_is_ever_due():  # law 15
    liveness, notices = linked(LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=0))
    assert liveness.due_ns(10, may_retry=True) is None
    assert liveness.listen(10**15) is None
    assert liveness.beat(10**15) is None
    assert notices == []


def test_something_to_say_again_is_due_after_the_retry_time():
    liveness, _ = linked(LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=0, retry_ns=25))
    assert liveness.due_ns(10, may_retry=True) == 25
    assert liveness.due_ns(10, may_retry=False) is None


def test_an_end_without_connection_is_never_due():
    liveness, notices = linked()
    liveness.turn(LinkEvent.CUT)
    assert liveness.due_ns(10, may_retry=True) is None
    assert notices == [LinkStateChanged(LinkState.APART)]
    assert not liveness.is_linked
