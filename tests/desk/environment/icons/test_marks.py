import pytest

from kit.desk.app_fixture import AppFixture
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_a_breakpoint_counts_once_for_an_action(gallery):  # R-D06, reading 24
    doc = gallery.begun("move", "there", "grip")
    job, target = gallery.number(doc, "move"), gallery.number(doc, "there")
    gallery.do(act.SetBreakpoint(doc, (job, target)))
    assert gallery.step(doc, "move").breaks
    assert not gallery.step(doc, "there").breaks
    assert str(gallery.view(doc).undo) == "setting 2 breakpoints"
    gallery.do(act.SetBreakpoint(doc, (target,), is_set=False))
    assert not gallery.step(doc, "move").breaks
    assert str(gallery.view(doc).undo) == "removing a breakpoint after move the joints"


def test_a_breakpoint_may_have_a_condition(gallery):  # R-D13
    doc = gallery.begun("grip")
    gallery.do(act.SetBreakpoint(doc, (gallery.number(doc, "grip"),), condition=" LAMP == 1 "))
    assert gallery.step(doc, "grip").break_if == "LAMP == 1"
    no = gallery.no(act.SetBreakpoint(doc, (gallery.number(doc, "grip"),), condition="lamp"))
    assert "condition" in no.fields


def test_a_tag_is_set_and_taken_away(gallery):  # R-D06
    doc = gallery.begun("move", "there", flows=2, is_parallel=True)
    gallery.do(act.SetSynchTag(doc, gallery.number(doc, "there"), "A"))
    assert gallery.step(doc, "move").synch_tag == "A"
    assert str(gallery.view(doc).undo) == "setting the tag A at move the joints"
    gallery.do(act.SetSynchTag(doc, gallery.number(doc, "move")))
    assert gallery.step(doc, "move").synch_tag == ""


@pytest.mark.parametrize("tag", ["two words", "x" * 17, "#1", "a\nb"])
def test_what_no_file_could_hold_is_no_tag(gallery, tag):  # R-D06
    doc = gallery.begun("grip")
    assert "tag" in gallery.no(act.SetSynchTag(doc, gallery.number(doc, "grip"), tag)).fields


def test_only_actions_bear_marks(gallery):  # R-D06
    doc = gallery.begun("move", "there")
    branch = gallery.do(act.InsertBranch(doc, "0", gallery.number(doc, "there")))
    assert "branch bears no marks" in str(gallery.no(act.SetSynchTag(doc, branch, "A")).reason)
    gallery.do(act.ExchangeIcon(doc, gallery.number(doc, "move"), "wait"))
    no = gallery.no(act.SetBreakpoint(doc, (gallery.number(doc, "there"),)))
    assert str(no.reason) == "above triangle belongs to no action, and only actions bear marks"
    assert str(gallery.no(act.SetBreakpoint(doc, ())).reason) == "nothing is selected"
    assert "no longer there" in str(gallery.no(act.SetBreakpoint(doc, (999,))).reason)
