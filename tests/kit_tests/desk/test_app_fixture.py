import pytest

from kit.desk.app_fixture import ONIKONS, AppFixture
from onika.wire import act


def test_its_icons_are_those_of_its_dictionary_and_flows_are_said_in_words(tmp_path):
    gallery = AppFixture(tmp_path)
    assert set(gallery.environment.tree.onikons) == {onikon.name for onikon in ONIKONS}
    doc = gallery.begun("move", flows=2)
    branch = gallery.do(act.InsertBranch(doc, "1"))
    assert (gallery.flow(doc), gallery.flow(doc, "1")) == ("move _", "<>")
    assert gallery.number(doc, "<>", "1") == branch
    assert gallery.step(doc, "_").kind == "hole"
    assert gallery.view(doc).name == gallery.application(doc).name


def test_what_is_not_there_is_said(tmp_path):
    gallery = AppFixture(tmp_path)
    doc = gallery.begun("grip")
    with pytest.raises(AssertionError, match="expected open in flow 0, found grip"):
        gallery.number(doc, "open")
    with pytest.raises(AssertionError, match="expected a flow 7"):
        gallery.flow(doc, "7")
