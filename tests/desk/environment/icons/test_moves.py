import pytest

from kit.desk.app_fixture import AppFixture
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def moved(gallery, doc, names, behind, path="0", source="0"):
    steps = tuple(gallery.number(doc, name, source) for name in names)
    after = gallery.number(doc, behind, path) if behind else 0
    gallery.do(act.MoveIcons(doc, steps, path, after))


def test_icons_are_moved_as_one_step_that_undo_takes_back(gallery):  # R-D05, R-X10
    doc = gallery.begun("grip", "wait", "open")
    moved(gallery, doc, ["grip"], "open")
    assert gallery.flow(doc) == "wait open grip"
    assert str(gallery.view(doc).undo) == "moving close the hand"
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == "grip wait open"


def test_a_job_takes_its_targets_and_its_marks_with_it(gallery):  # R-D05, R-D06
    doc = gallery.begun("move", "there", "grip", flows=2)
    number = gallery.number(doc, "move")
    gallery.do(act.SetSynchTag(doc, number, "A"))
    gallery.do(act.MoveIcons(doc, (number,), "1", 0))
    assert (gallery.flow(doc), gallery.flow(doc, "1")) == ("grip", "move there")
    assert gallery.number(doc, "move", "1") == number
    assert gallery.step(doc, "move", "1").synch_tag == "A"


def test_a_job_that_lacks_its_target_takes_its_hole_along(gallery):  # R-D19
    doc = gallery.begun("move", flows=2)
    moved(gallery, doc, ["move"], "", "1")
    assert (gallery.flow(doc), gallery.flow(doc, "1")) == ("", "move _")


def test_a_target_alone_leaves_a_hole_and_fills_another(gallery):  # R-D19
    doc = gallery.begun("move", "there", "visit")
    moved(gallery, doc, ["there"], "visit")
    assert gallery.flow(doc) == "move _ visit there"


def test_a_move_that_would_be_illegal_is_refused_whole(gallery):  # R-D03
    doc = gallery.begun("move", "there", "grip")
    steps = (gallery.number(doc, "grip"),)
    no = gallery.no(act.MoveIcons(doc, steps, "0", gallery.number(doc, "move")))
    assert str(no.reason) == "a Complete job does not fit behind “move the joints”: it needs a Joint target"
    assert all(remedy.act is None for remedy in no.remedies)
    target = (gallery.number(doc, "there"),)
    assert "no action" in str(gallery.no(act.MoveIcons(doc, target, "0", 0)).reason)


def test_moving_behind_one_of_themselves_or_nowhere_changes_nothing(gallery):  # R-D05
    doc = gallery.begun("grip", "wait", "open")
    before = gallery.view(doc).undo
    moved(gallery, doc, ["wait"], "wait")
    moved(gallery, doc, ["wait"], "grip")
    assert gallery.flow(doc) == "grip wait open"
    assert gallery.view(doc).undo == before


def test_several_icons_from_several_flows_come_together_in_their_order(gallery):  # R-D05
    doc = gallery.begun("grip", "wait", flows=2)
    gallery.add(doc, "open", flow="1")
    steps = (gallery.number(doc, "open", "1"), gallery.number(doc, "grip"))
    gallery.do(act.MoveIcons(doc, steps, "1", 0))
    assert (gallery.flow(doc), gallery.flow(doc, "1")) == ("wait", "grip open")


def test_icons_move_into_branches_and_out_but_no_branch_into_itself(gallery):  # R-D13
    doc = gallery.begun("grip", "wait")
    branch = gallery.do(act.InsertBranch(doc, "0", gallery.number(doc, "wait")))
    inner = f"0/{branch}/0"
    moved(gallery, doc, ["grip"], "", inner)
    assert (gallery.flow(doc), gallery.flow(doc, inner)) == ("wait <>", "grip")
    assert "into itself" in str(gallery.no(act.MoveIcons(doc, (branch,), inner, 0)).reason)
    gallery.do(act.MoveIcons(doc, (branch,), "0", 0))
    assert (gallery.flow(doc), gallery.flow(doc, inner)) == ("<> wait", "grip")
    moved(gallery, doc, ["grip"], "wait", "0", inner)
    assert (gallery.flow(doc), gallery.flow(doc, inner)) == ("<> wait grip", "")


def test_a_hole_cannot_be_moved(gallery):  # R-D19
    doc = gallery.begun("move")
    assert "no icon" in str(gallery.no(act.MoveIcons(doc, (gallery.number(doc, "_"),), "0", 0)).reason)


def test_what_is_moved_onto_an_icon_comes_in_its_place_as_one_step(gallery):  # R-D05, R-X10
    doc = gallery.begun("grip", "wait", "open")
    grip, opens = gallery.number(doc, "grip"), gallery.number(doc, "open")
    gallery.do(act.MoveIcons(doc, (opens,), "0", 0, replaces=grip))
    assert gallery.flow(doc) == "open wait"
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == "grip wait open"


def test_an_action_comes_for_a_whole_action_and_a_target_for_a_target(gallery):  # R-D05, R-D19
    doc = gallery.begun("move", "there", "visit", "here", "grip")
    move, there, visit, here, grip = (gallery.number(doc, name) for name in ("move", "there", "visit", "here", "grip"))
    gallery.do(act.MoveIcons(doc, (grip,), "0", 0, replaces=visit))
    assert gallery.flow(doc) == "move there grip"
    gallery.do(act.Undo(doc))
    gallery.do(act.MoveIcons(doc, (here,), "0", 0, replaces=there))
    assert gallery.flow(doc) == "move here visit _ grip"
    gallery.do(act.Undo(doc))
    gallery.do(act.MoveIcons(doc, (move,), "0", 0, replaces=visit))
    assert gallery.flow(doc) == "move there grip"


def test_onto_an_icon_where_it_does_not_fit_nothing_is_moved(gallery):  # R-D03
    doc = gallery.begun("move", "there", "grip")
    grip, there = gallery.number(doc, "grip"), gallery.number(doc, "there")
    assert "needs a Joint target" in str(gallery.no(act.MoveIcons(doc, (grip,), "0", 0, replaces=there)).reason)
    assert gallery.flow(doc) == "move there grip"


def test_onto_one_of_themselves_nothing_changes(gallery):  # R-D05
    doc = gallery.begun("move", "there", "grip")
    move, there = gallery.number(doc, "move"), gallery.number(doc, "there")
    gallery.do(act.MoveIcons(doc, (move,), "0", 0, replaces=there))
    assert gallery.flow(doc) == "move there grip"
