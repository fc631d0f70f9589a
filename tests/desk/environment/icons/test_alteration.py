import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.icons.alteration import altered, flow_at, place_behind, reflowed, spots_of
from onika.desk.environment.outcome.outcome import No
from onika.model.application import AppFlow
from onika.words.reason import Reason


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_a_change_is_a_step_with_its_label_and_new_steps_get_numbers(gallery):  # R-D05
    doc = gallery.begun("grip")
    opened = gallery.environment.model.applications[doc]
    steps = (*opened.application.flows[0].steps, gallery.application(gallery.begun("open")).flows[0].steps[0])
    bare = AppFlow((steps[0], type(steps[1])(steps[1].onikon)))
    done = reflowed(gallery.environment.model, opened, {"0": bare}, Reason.plain("doing"), "value")
    assert (str(done.label), done.doc, done.value) == ("doing", doc, "value")
    after = done.model.applications[doc]
    assert [step.number for step in after.application.flows[0].steps] == [1, 2]
    assert after.last_number == 2
    same = altered(gallery.environment.model, opened, opened.application, Reason.plain("nothing"))
    assert same.model.applications[doc].application is opened.application


def test_a_place_is_found_behind_a_step_or_at_the_beginning(gallery):  # R-D05
    doc = gallery.begun("grip", "open", flows=2)
    application = gallery.application(doc)
    assert place_behind(application, "1", 0) == ("1", -1)
    assert place_behind(application, "1", gallery.number(doc, "open")) == ("0", 1)
    assert isinstance(place_behind(application, "2", 0), No)
    assert isinstance(place_behind(application, "0", 99), No)
    assert flow_at(application, "5") is None


def test_steps_are_found_in_their_order_and_those_that_are_gone_passed_over(gallery):
    doc = gallery.begun("grip", "open")
    first, other = gallery.number(doc, "grip"), gallery.number(doc, "open")
    assert [spot.step.number for spot in spots_of(gallery.application(doc), (other, 99, first))] == [first, other]
    assert str(spots_of(gallery.application(doc), (99,)).reason) == "what was selected is no longer there"
