from onika.desk.console.commands import LOOKS
from onika.wire import event, live
from onika.words.reason import Reason


def test_a_subsystem_is_recorded_into_a_file_and_no_more(sit, tmp_path):  # R-X05
    sitting = sit()
    path = tmp_path / "a.mcap"
    sitting.does(f"record jog {path}", "record jog off", f"record {path}", "record off")
    asked = sitting.requests_of(live.Record)
    main = sitting.session.subsystem
    assert asked == [
        live.Record("jog", str(path)),
        live.Record("jog"),
        live.Record(main, str(path)),
        live.Record(main),
    ]


def test_a_file_that_is_there_is_not_written_over(sit, tmp_path):  # R-X05
    sitting = sit()
    path = tmp_path / "a.mcap"
    path.write_text("mine")
    assert sitting.fails(f"record {path}").reason == Reason.of("console.recording_exists", path=str(path))
    assert sitting.requests_of(live.Record) == []


def test_the_runtimes_refusal_is_told(sit, tmp_path):  # R-X05
    sitting = sit()
    sitting.runtime.refusals["Record"] = Reason.of("host.nothing_to_record", subsystem="jog")
    refusal = sitting.fails(f"record jog {tmp_path / 'a.mcap'}").reason
    assert refusal.key == "console.runtime_refused" and "nothing lives" in str(refusal)


def test_begin_and_end_of_a_recording_are_told(sit):  # R-X05
    sitting = sit()
    sitting.runtime.tell(event.Recording("jog", 1.0, "/a.mcap", is_on=True))
    sitting.runtime.tell(event.Recording("jog", 3.5, "/a.mcap", is_on=False, cause=Reason.plain("full"), lasted_s=2.5))
    begun, ended = [line for line in sitting.does("echo") if line]
    assert "jog is being recorded into /a.mcap" in begun
    assert "recorded 2.5 s into /a.mcap" in ended and "full" in ended


def test_it_stands_among_what_changes_nothing():  # R-X05
    assert "record" in {command.name for command in LOOKS}
