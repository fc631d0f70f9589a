import pytest
from msgspec import structs

from kit.labs.laboratory import job
from kit.record.recording_builder import RecordingBuilder, run
from onika.wire import act, request

THREE = [job("aC"), job("bC"), job("cC")]


@pytest.fixture
def doc(cinema):
    return cinema.open(THREE)


def shown(cinema):
    review = cinema.environment.tree.review
    return review.recording, [passage.step for passage in review.recording.flows["flow0"].passages]


def test_an_application_that_is_closed_and_opened_again_is_shown_at_its_icons(cinema, doc):  # R-X05
    cinema.look(cinema.film(doc))
    path = str(cinema.environment.model.applications[doc].opened.path)
    cinema.do(act.Close(doc))
    assert shown(cinema)[0].doc == ""
    again = cinema.do(act.Open(path))
    cinema.become()
    view, steps = shown(cinema)
    assert (view.doc, 0 in steps) == (again, False)
    assert cinema.glance(1.5).run.flows["flow0"].step == steps[1]


def test_one_that_was_recorded_from_another_folder_is_found_by_its_name(cinema, doc):  # R-X05
    film = cinema.tape(doc)
    film.end()
    there = structs.replace(film.plan, application="play")
    actions = tuple(structs.replace(action, place="elsewhere/play.appl") for action in there.flows[0].actions)
    elsewhere = structs.replace(there, flows=(structs.replace(there.flows[0], actions=actions),))
    tape = RecordingBuilder(
        cinema.base.path / "elsewhere.mcap", structs.replace(run(), prepare=request.Prepare(elsewhere, ()))
    )
    tape.end()
    assert cinema.look(tape.path).doc == doc
    path = str(cinema.environment.model.applications[doc].opened.path)
    cinema.do(act.Close(doc))
    again = cinema.do(act.Open(path))
    cinema.become()
    assert shown(cinema)[0].doc == again


def test_icons_that_were_read_again_are_the_ones_at_which_it_is_shown(cinema, doc):  # R-X05, R-X10
    cinema.look(cinema.film(doc))
    cinema.files.application("play", [job("cC")])
    cinema.do(act.Reload(doc))
    cinema.become()
    view, steps = shown(cinema)
    icons = cinema.environment.tree.applications[doc].steps
    assert [icons[str(step)].name if step else "" for step in steps] == ["", "", "cC"]
    assert "2 of 3 recorded actions have no icon now" in str(view.notes[0])


def test_another_application_changes_nothing(cinema, doc):  # R-X05
    cinema.look(cinema.film(doc))
    subject = cinema.environment.model.review_session.subject
    cinema.open(THREE, name="other")
    assert cinema.changes.empty()
    assert cinema.environment.model.review_session.subject is subject


def test_what_was_put_away_meanwhile_stays_away(cinema, doc):  # R-X05
    cinema.look(cinema.film(doc))
    path = str(cinema.environment.model.applications[doc].opened.path)
    cinema.do(act.Close(doc))
    cinema.do(act.Open(path))
    cinema.do(act.CloseRecording())
    cinema.surroundings.reading.answer(lambda: None, "all before is done")
    cinema.become()
    assert cinema.environment.tree.review is None
