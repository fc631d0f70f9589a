import pytest
from msgspec import structs

from kit.record.recording_builder import RecordingBuilder, run
from onika.record.reader import Reader
from onika.record.run import RunRecord, ending
from onika.record.writer import Writer
from onika.wire import steer
from onika.wire.event import Result
from onika.wire.request import Recorded, encode
from onika.words.reason import Reason


def test_a_run_comes_back_as_it_was_with_its_code(tmp_path):  # law 29
    begin = structs.replace(run().begin, answers=(("a", "b", "1 2"),), repeat=(Recorded(5, 1, encode(steer.Who())),))
    given = structs.replace(run(), begin=begin, options=("--shake", "3", "--world-value", "boxes.mass=2.0"))
    copy = RunRecord.read(RecordingBuilder(tmp_path / "run.mcap", given).end())
    assert copy == given
    by_hand = structs.replace(run(), is_by_hand=True)
    assert RunRecord.read(RecordingBuilder(tmp_path / "by_hand.mcap", by_hand).end()) == by_hand
    assert copy.prepare.plan.code[0].source


def test_its_modules_lie_in_the_file_as_files_of_their_own(tmp_path):
    reader = RecordingBuilder(tmp_path / "run.mcap").end()
    sources = [reader.attachment(attachment) for attachment in reader.attachments if attachment.startswith("code/")]
    assert any(b"class Servo(Module)" in source for source in sources)


def test_the_same_plan_has_the_same_hash_and_another_one_another():  # law 29
    other = structs.replace(run().prepare, plan=structs.replace(run().prepare.plan, application="another"))
    assert run().plan_hash == run(seed=9).plan_hash
    assert structs.replace(run(), prepare=other).plan_hash != run().plan_hash


def test_a_file_without_a_run_is_refused(tmp_path):  # R-E01
    path = tmp_path / "run.mcap"
    with path.open("wb") as stream:
        Writer(stream).finish()
    with pytest.raises(ValueError, match="expected a recording of a run"):
        RunRecord.read(Reader(path))


def test_how_a_run_ended_is_noted():  # R-X05
    result = Result(False, Reason.plain("enough"), 1, 2, 1.25, 9.0, {}, (), "abc", outside=("flow0/planner",))
    assert ending(result) == {
        "completed": "no", "cause": "enough", "hash": "abc", "seconds": "1.25", "outside": "flow0/planner"
    }  # fmt: skip


@pytest.mark.parametrize("part", [0.01, 0.3, 0.6])
def test_a_file_that_was_cut_before_its_run_began_says_so(tmp_path, part):  # R-E01
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.end().close()
    data = tape.path.read_bytes()
    tape.path.write_bytes(data[: max(9, int(part * data.index(b"class Servo(Module)")))])
    with pytest.raises(ValueError, match="cut short before anything was run"):
        RunRecord.read(Reader(tape.path))


@pytest.mark.parametrize(
    "options",
    [
        "--audit /tmp/x",
        "--listen 0.0.0.0:1",
        "--shake",
        "--shake 3 --audit x",
        "--world-value x.y=1 --audit",
        "--shake -1",
    ],
)
def test_a_recording_gives_no_orders_to_the_runtime_that_repeats_it(tmp_path, options):  # R-X05, R-X12
    reader = RecordingBuilder(tmp_path / "run.mcap", run(options=tuple(options.split()))).end()
    with pytest.raises(ValueError) as refused:
        RunRecord.read(reader)
    assert refused.value.args[0].args["why"].key == "record.options"


@pytest.mark.parametrize("units", [("--listen",), ("a\x1b[2J",), ("u",) * 100])
def test_a_recording_names_units_and_nothing_else(tmp_path, units):  # R-X05
    reader = RecordingBuilder(tmp_path / "run.mcap", structs.replace(run(), rtpus=units)).end()
    with pytest.raises(ValueError) as refused:
        RunRecord.read(reader)
    assert refused.value.args[0].args["why"].key == "record.units"
