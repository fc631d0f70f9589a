import pytest

from kit.desk.app_fixture import AppFixture
from onika.wire import act

VALUES = (("1", "2", "3", "4", "5", "6"), ("0.5",))


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_only_this_one_instance_is_changed(gallery):  # R-D17
    doc = gallery.begun("move", "there", "visit", "there")
    gallery.do(act.EditIcon(doc, gallery.number(doc, "there"), "over there", VALUES, "3" * 1024))
    first, second = (step for step in gallery.view(doc).steps.values() if step.name == "there")
    assert (first.description, first.values) == ("over there", (("1", "2", "3", "4", "5", "6"), ("0.5",)))
    assert (second.description, first.picture == second.picture) == ("above triangle", False)
    assert str(gallery.view(doc).undo) == "changing above triangle"
    assert gallery.environment.tree.onikons["there"].description == "above triangle"


def test_values_are_looked_at_one_by_one(gallery):  # R-D08
    doc = gallery.begun("move", "there")
    wrong = (("1", "2", "x", "4", "5", ""), ("inf",))
    no = gallery.no(act.EditIcon(doc, gallery.number(doc, "there"), values=wrong))
    assert set(no.fields) == {"endpoint[2]", "endpoint[5]", "duration"}
    assert gallery.no(act.EditIcon(doc, gallery.number(doc, "there"), values=(("1",),))).fields


def test_a_job_has_no_values_and_a_picture_1024_digits(gallery):  # R-D07
    doc = gallery.begun("grip")
    number = gallery.number(doc, "grip")
    assert "no values" in str(gallery.no(act.EditIcon(doc, number, values=VALUES)).reason)
    assert "picture" in gallery.no(act.EditIcon(doc, number, picture="123")).fields
    gallery.do(act.EditIcon(doc, number, "  take \n it "))
    assert gallery.step(doc, "grip").description == "take it"


def test_nothing_else_can_be_changed_so_and_no_change_is_no_step(gallery):
    doc = gallery.begun("move")
    label = gallery.view(doc).undo
    gallery.do(act.EditIcon(doc, gallery.number(doc, "move"), "move the joints"))
    assert gallery.view(doc).undo == label
    assert "only icons" in str(gallery.no(act.EditIcon(doc, gallery.number(doc, "_"), "x")).reason)
    assert "no longer there" in str(gallery.no(act.EditIcon(doc, 99, "x")).reason)
