from io import BytesIO

from kit.record.recording_builder import RecordingBuilder
from onika.record.homeless_copy import homeless_copy
from onika.record.reader import Reader
from onika.record.run import RunRecord
from onika.record.series import Series
from onika.wire import event
from onika.words.reason import Reason

SECRET = "/home/ana/lab/module/zdiff.py"


def copied(tmp_path, *, ends=True):
    tape = RecordingBuilder(tmp_path / "film.mcap")
    tape.variable("X", "double", (0.0, 1.5), (1.0, 2.5))
    tape.tell(0.5, event.Failed("flow0", "diff", Reason.plain(SECRET), "cycle", 3, SECRET, "", 0.5), "flow0")
    tape.end(completed="no", cause=SECRET) if ends else tape.cut()
    stream = BytesIO()
    reader = Reader(tape.path)
    homeless_copy(reader, stream)
    (tmp_path / "copy.mcap").write_bytes(stream.getvalue())
    return reader, Reader(tmp_path / "copy.mcap")


def test_a_copy_holds_the_run_and_names_no_home(tmp_path):  # R-X21: nothing secret
    first, second = copied(tmp_path)
    assert [*Series.all_of(second)["flow0/X"].values()] == [*Series.all_of(first)["flow0/X"].values()]
    events = [body for _, body in second.messages("/events")]
    assert len(events) == first.count("/events") and b"~/lab/module/zdiff.py" in b"".join(events)
    assert b"/home/" not in b"".join(events)
    assert second.notes["end"]["cause"] == "~/lab/module/zdiff.py"
    assert second.is_whole
    assert RunRecord.read(second).prepare.plan.application == RunRecord.read(first).prepare.plan.application
    assert second.attachments == first.attachments


def test_what_was_cut_short_stays_so(tmp_path):  # R-X21: bad input
    first, second = copied(tmp_path, ends=False)
    assert (first.is_whole, second.is_whole) == (False, False)
