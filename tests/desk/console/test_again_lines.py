import pytest

from onika.wire import live
from onika.words.reason import Reason


@pytest.fixture
def tight(sit):
    """A sitting in which a task has found no gap between the cycles of rt0."""
    sitting = sit()
    sitting.does("spawn puma")
    sitting.runtime.tight = {"rt0"}
    fault = sitting.fails("spawn pd")
    assert "largest gap here is 1.89 ms" in str(fault.reason)
    assert fault.instead == Reason.of("console.ways_again")
    return sitting


def test_it_is_done_again_in_a_moment_of_hold(tight):  # law 21
    tight.does("again hold")
    first, last = tight.requests_of(live.Change)[-2:]
    assert (first.holds, last.holds) == (False, True) and first.spawn == last.spawn
    assert tight.states() == {"puma": "OFF", "pd": "OFF"}
    assert tight.fails("again hold").reason.key == "console.nothing_without_gap"


def test_it_is_done_again_on_another_unit(tight):  # R-A06, law 21
    assert tight.fails("again rt7").reason.key == "console.unit_unknown"
    tight.does("again rt1")
    assert {name: task.rtpu for name, task in tight.session.tasks().items()} == {"puma": "rt0", "pd": "rt1"}


def test_code_is_exchanged_again_in_a_moment_of_hold_alone(sit):  # R-X15, law 21
    sitting = sit()
    sitting.does("spawn pd")
    sitting.runtime.tight = {"rt0"}
    sitting.fails("swap pd")
    assert sitting.fails("again rt1").reason.key == "console.code_stays_on_unit"
    sitting.does("again hold")
    assert [order.holds for order in sitting.requests_of(live.Swap)] == [False, True]


@pytest.mark.parametrize("line", ["again", "again hold rt1", "again at once"])
def test_other_words_are_refused(tight, line):
    changes = len(tight.requests_of(live.Change))
    tight.console.carry_out(line)
    assert len(tight.requests_of(live.Change)) == changes


def test_without_anything_that_found_no_gap_there_is_nothing_to_do_again(sit):
    assert sit().fails("again hold").reason.key == "console.nothing_without_gap"
