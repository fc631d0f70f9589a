import pytest
from msgspec import structs

from kit.labs.laboratory import job
from kit.record.recording_builder import RecordingBuilder, run
from onika.wire import act, event, request
from onika.wire.plan import Plan, PlannedFlow
from onika.words.reason import NOTHING

THREE = [job("aC"), job("bC"), job("cC")]


@pytest.fixture
def doc(cinema):
    return cinema.open(THREE)


def steps(view):
    return [passage.step for passage in view.flows["flow0"].passages]


def test_a_recorded_run_is_shown_with_its_flows_variables_and_worlds(cinema, doc):  # R-X05
    view = cinema.look(cinema.film(doc))
    assert (view.name, view.doc, view.is_virtual, view.is_whole, view.is_completed) == ("play", doc, True, True, True)
    assert (view.begin_s, view.end_s) == (0.0, 3.0)
    assert view.began_at_s > 1.7e9
    assert steps(view) == [1, 2, 3]
    assert (view.variables["flow0/A"].unit, view.variables["flow0/A"].labels) == ("s", ("A",))
    assert (view.worlds, view.notes, view.cannot_continue) == (("yard",), (), NOTHING)


def test_a_recording_that_was_cut_short_is_looked_at_and_says_so(cinema, doc):  # R-X05: kill -9
    path = cinema.film(doc, ends=False)
    whole = path.read_bytes()
    view = cinema.look(path)
    assert (view.is_whole, view.is_completed) == (False, False)
    assert view.notes[0].key == "run.lost_cut"
    path.with_stem("half").write_bytes(whole[: len(whole) - 7])
    assert cinema.later(act.OpenRecording(str(path.with_stem("half")))).no is None


@pytest.mark.parametrize("content", [b"", b"nonsense", b"\x89MCAP0\r\n", b"\x89MCAP0\r\n" + b"\x07" * 400])
def test_what_is_no_recording_is_refused_with_the_reason(cinema, tmp_path, content):  # R-X05
    path = tmp_path / "odd.mcap"
    path.write_bytes(content)
    no = cinema.later(act.OpenRecording(str(path))).no
    assert no is not None and "odd.mcap cannot be looked at: " in str(no.reason)
    assert cinema.environment.tree.review is None


def test_a_file_that_is_not_there_or_cannot_be_read_is_refused(cinema, tmp_path):
    assert "no such file" in str(cinema.later(act.OpenRecording(str(tmp_path / "none.mcap"))).no.reason)
    assert "found a folder" in str(cinema.later(act.OpenRecording(str(tmp_path))).no.reason)


def test_no_spoilt_file_breaks_anything(cinema, doc, tmp_path):  # R-X05: garbage anywhere
    whole = cinema.film(doc).read_bytes()
    path = tmp_path / "spoilt.mcap"
    for at in range(8, len(whole), len(whole) // 60):
        path.write_bytes(whole[:at] + bytes([whole[at] ^ 0xFF]) + whole[at + 1 :])
        answer = cinema.later(act.OpenRecording(str(path)))
        assert answer.no is None or "spoilt.mcap cannot be looked at" in str(answer.no.reason)
        if answer.no is None:
            assert cinema.answer(act.Glance(1.0)).no is None or "cannot be read" in str(
                cinema.answer(act.Glance(1.0)).no.reason
            )


def test_its_application_is_opened_with_it(cinema, doc):  # R-X05: the page shows the flows
    path = cinema.film(doc)
    cinema.do(act.Close(doc))
    view = cinema.look(path)
    assert view.doc in cinema.environment.tree.applications and view.doc != doc
    assert steps(view) != [0, 0, 0]


def test_without_its_application_it_is_shown_without_icons(cinema, doc):  # R-X05
    path = cinema.film(doc)
    cinema.do(act.Close(doc))
    (cinema.base.path / "appl" / "play.appl").unlink()
    view = cinema.look(path)
    assert (view.doc, steps(view)) == ("", [0, 0, 0])
    assert view.notes[0].key == "run.is_not_open" and view.notes[0].args["name"] == "play"
    assert view.flows["flow0"].passages[0].name == "aC"


def test_an_application_that_has_changed_shows_what_is_still_there(cinema, doc):  # R-X05: icons that are others now
    path = cinema.film(doc)
    cinema.do(act.RemoveIcons(doc, (2,)))
    view = cinema.look(path)
    assert steps(view) == [1, 0, 3]
    assert "1 of 3 recorded actions has no icon now" in str(view.notes[0])


def test_another_recording_takes_its_place_and_closing_puts_it_away(cinema, doc):  # R-X05
    cinema.look(cinema.film(doc, "one"))
    first = cinema.environment.model.review_session.subject
    assert cinema.look(cinema.film(doc, "two")).path.endswith("two.mcap")
    assert first.away.is_set()
    cinema.do(act.CloseRecording())
    assert cinema.environment.tree.review is None
    assert str(cinema.no(act.Glance(0.0)).reason) == "no recording is looked at"
    cinema.do(act.CloseRecording())


def test_last_seconds_of_what_was_held_by_hand_need_no_application(cinema, tmp_path):  # R-X05
    plan = Plan("jog", (PlannedFlow("jog", (), ()),), ())
    by_hand = structs.replace(run(), prepare=request.Prepare(plan, ()), is_by_hand=True, is_fresh=False)
    tape = RecordingBuilder(tmp_path / "jog.mcap", by_hand, (0.5, 2.0))
    tape.variable("X", "double", (0.5, 1.0), (2.0, 3.0), home="jog")
    tape.tell(1.0, event.TaskState("jog", "servo", "ERROR", 1.0), "jog")
    tape.end(completed="no", goes_on="yes", cause="servo: broken")
    view = cinema.look(tape.path)
    assert (view.name, view.doc, view.is_completed) == ("jog", "", False)
    assert [note.key for note in view.notes][:3] == [
        "desk.digest_black_box_by_hand",
        "desk.digest_black_box_workcell",
        "run.was_by_hand",
    ]
    assert list(view.variables) == ["jog/X"]
    assert view.cannot_continue
