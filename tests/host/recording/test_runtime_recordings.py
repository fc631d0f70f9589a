"""What a runtime writes down stands together: by hand and in black boxes, until the runtime or its program ends."""

import pytest
from tests.host.recording.test_hand_held import ByHand

from onika.host.recording.black_box_holder import InProcessHolder
from onika.host.recording.runtime_recordings import RuntimeRecordings
from onika.record.reader import Reader
from onika.wire import live


@pytest.fixture
def hand(tmp_path):
    by_hand = ByHand(tmp_path / "boxes")
    by_hand.file = tmp_path / "push.mcap"
    assert by_hand.edits.asker.ask(live.Record("s0", str(by_hand.file)))
    by_hand.edits.let_pass(0.2)
    yield by_hand
    by_hand.edits.asker.program.close()


def test_when_the_runtime_ends_what_is_open_is_written(hand):  # R-X05
    recordings = hand.edits.asker.program.recordings
    recordings.finish()
    assert Reader(hand.file).is_whole
    assert recordings.readers() == []


class Server:
    """Knows who overhears it."""

    def __init__(self):
        self.observers = []
        self.overhear, self.leave = self.observers.append, self.observers.remove

    def tell(self, message, subsystem=""):
        raise AssertionError("there is nothing to tell")


def test_who_leaves_its_links_to_another_program_hears_nothing_of_them_any_more(hand, tmp_path):  # R-X23
    server, edits = Server(), hand.edits
    recordings = RuntimeRecordings(edits.asker.program.subsystems, edits.driver, server)
    recordings.keep_last_seconds(tmp_path / "others", InProcessHolder(), InProcessHolder)
    assert len(server.observers) == 2
    recordings.leave()
    assert server.observers == []


def test_without_a_black_box_nothing_is_due_by_itself(hand):  # R-X05
    recordings = RuntimeRecordings(hand.edits.asker.program.subsystems, hand.edits.driver, Server())
    assert recordings.due_ns() is None
