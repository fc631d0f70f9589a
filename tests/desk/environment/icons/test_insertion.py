import pytest

from kit.desk.app_fixture import ONIKONS, AppFixture, onikon
from onika.wire import act
from onika.wire.view import ShowFits


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_an_icon_is_inserted_behind_another_and_a_hole_opens_where_the_next_does_not_fit(gallery):  # R-D03
    doc = gallery.begun("grip")
    number = gallery.do(act.InsertIcon(doc, "move"))
    assert gallery.flow(doc) == "move _ grip"
    assert gallery.number(doc, "move") == number
    assert str(gallery.view(doc).undo) == "inserting move the joints"
    assert gallery.view(doc).holes == 1


def test_a_fitting_icon_fills_the_hole_and_one_that_fits_only_left_leaves_it(gallery):  # R-D03, R-D19
    doc = gallery.begun("move")
    gallery.do(act.InsertIcon(doc, "there", "0", gallery.number(doc, "_")))
    assert gallery.flow(doc) == "move there"
    assert gallery.view(doc).holes == 0
    gallery.do(act.InsertIcon(doc, "slide", "0", gallery.number(doc, "there")))
    assert gallery.flow(doc) == "move there slide _"


def test_a_refusal_says_why_in_words_and_offers_what_fits(gallery):  # R-D03, R-X01
    doc = gallery.begun("move")
    number = gallery.number(doc, "move")
    no = gallery.no(act.InsertIcon(doc, "spot", "0", number))
    assert str(no.reason) == "a Cartesian target does not fit behind “move the joints”: it needs a Joint target"
    labels = [str(remedy.label) for remedy in no.remedies]
    assert labels == [
        "Use beside the box",
        "Use above triangle",
        "Change move the joints to move on a straight line",
        "Show the 2 that fit",
    ]
    assert no.remedies[-1].show == ShowFits("0", number)
    gallery.do(no.remedies[2].act)
    assert gallery.flow(doc) == "slide _"
    gallery.do(act.InsertIcon(doc, "spot", "0", number))
    assert gallery.flow(doc) == "slide spot"


def test_each_button_of_a_refusal_does_what_it_says(gallery):  # R-X01
    for place in range(2):
        doc = gallery.begun("move")
        no = gallery.no(act.InsertIcon(doc, "grip", "0", gallery.number(doc, "move")))
        assert str(no.reason) == "a Complete job does not fit behind “move the joints”: it needs a Joint target"
        assert 1 < len(no.remedies) <= 4
        gallery.do(no.remedies[place].act)
        assert "_" not in gallery.flow(doc)


def test_a_target_at_the_beginning_is_refused_and_so_is_an_unknown_name(gallery):  # R-D03
    doc = gallery.begun()
    no = gallery.no(act.InsertIcon(doc, "there"))
    assert str(no.reason) == "a Joint target does not fit behind the start: there is no action to give it to"
    assert [remedy.act.onikon for remedy in no.remedies if remedy.act]
    assert str(gallery.no(act.InsertIcon(doc, "nobody")).reason) == "no open dictionary has an icon nobody"
    doc = gallery.begun("move", "there")
    no = gallery.no(act.InsertIcon(doc, "here", "0", gallery.number(doc, "there")))
    assert str(no.reason) == "a Joint target does not fit behind “above triangle”: an action comes next"


def test_where_somebody_else_deleted_the_neighbour_nothing_is_inserted_elsewhere(gallery):  # R-D05
    doc = gallery.begun("grip", "open")
    number = gallery.number(doc, "open")
    gallery.do(act.RemoveIcons(doc, (number,)))
    assert "no longer there" in str(gallery.no(act.InsertIcon(doc, "wait", "0", number)).reason)
    assert "flow is no longer there" in str(gallery.no(act.InsertIcon(doc, "wait", "7")).reason)


def test_a_neighbour_that_moved_to_another_flow_is_found_there(gallery):  # R-D05
    doc = gallery.begun("grip", flows=2)
    number = gallery.number(doc, "grip")
    gallery.do(act.MoveIcons(doc, (number,), "1", 0))
    gallery.do(act.InsertIcon(doc, "wait", "0", number))
    assert (gallery.flow(doc), gallery.flow(doc, "1")) == ("", "grip wait")


def test_deleting_opens_and_closes_holes_as_one_step(gallery):  # R-D05, R-D19
    doc = gallery.begun("grip", "move", "there", "open")
    gallery.do(act.RemoveIcons(doc, (gallery.number(doc, "there"),)))
    assert gallery.flow(doc) == "grip move _ open"
    gallery.do(act.RemoveIcons(doc, (gallery.number(doc, "move"), gallery.number(doc, "grip"))))
    assert gallery.flow(doc) == "open"
    assert str(gallery.view(doc).undo) == "deleting 2 icons"
    gallery.do(act.Undo(doc))
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == "grip move there open"


def test_a_hole_cannot_be_deleted_and_start_and_end_are_no_steps(gallery):  # R-D04, R-D19
    doc = gallery.begun("move")
    assert "cannot be deleted" in str(gallery.no(act.RemoveIcons(doc, (gallery.number(doc, "_"),))).reason)
    assert "no longer there" in str(gallery.no(act.RemoveIcons(doc, (0,))).reason)
    assert str(gallery.no(act.RemoveIcons(doc, ())).reason) == "nothing is selected"


def test_numbers_are_never_used_again(gallery):  # R-D05
    doc = gallery.begun("grip")
    first = gallery.number(doc, "grip")
    gallery.do(act.RemoveIcons(doc, (first,)))
    second = gallery.do(act.InsertIcon(doc, "grip"))
    gallery.do(act.Undo(doc))
    third = gallery.do(act.InsertIcon(doc, "grip"))
    assert len({first, second, third}) == 3


def test_an_icon_is_exchanged_with_its_marks(gallery):  # R-D05, R-D06
    doc = gallery.begun("move", "there", "grip")
    move = gallery.number(doc, "move")
    gallery.do(act.SetBreakpoint(doc, (move,)))
    gallery.do(act.ExchangeIcon(doc, move, "visit"))
    assert gallery.flow(doc) == "visit there grip"
    assert gallery.view(doc).steps[str(move)].breaks
    assert str(gallery.view(doc).undo) == "exchanging move the joints for visit a place"
    gallery.do(act.ExchangeIcon(doc, move, "slide"))
    assert gallery.flow(doc) == "slide _ there grip"
    gallery.do(act.ExchangeIcon(doc, move, "move"))
    assert gallery.flow(doc) == "move there grip"


def test_an_icon_that_does_not_fit_there_is_no_exchange(gallery):  # R-D03
    doc = gallery.begun("move", "there")
    no = gallery.no(act.ExchangeIcon(doc, gallery.number(doc, "there"), "grip"))
    assert str(no.reason) == "a Complete job does not fit behind “move the joints”: it needs a Joint target"
    gallery.do(act.RemoveIcons(doc, (gallery.number(doc, "there"),)))
    gallery.do(act.ExchangeIcon(doc, gallery.number(doc, "_"), "here"))
    assert gallery.flow(doc) == "move here"


def test_what_an_icon_of_the_dictionary_becomes_later_does_not_change_what_is_placed(gallery, tmp_path):  # R-D05
    doc = gallery.begun("grip")
    base = gallery.base
    opened, _ = base.open_onikon("grip", gallery.environment.model.syntax)
    base.save_onikon(onikon("grip", "Complete job", "something else"), opened, overwrites=True)
    assert gallery.step(doc, "grip").description == "close the hand"


def test_a_branch_is_inserted_with_empty_flows_and_filled_by_its_paths(gallery):  # R-D13
    doc = gallery.begun("grip")
    branch = gallery.do(act.InsertBranch(doc, "0", gallery.number(doc, "grip"), 2, ("LAMP == 1",)))
    view = gallery.view(doc).steps[str(branch)]
    assert (view.kind, view.conditions, view.flows) == ("branch", ("LAMP == 1",), (f"0/{branch}/0", f"0/{branch}/1"))
    gallery.add(doc, "move", "there", flow=f"0/{branch}/1")
    assert gallery.flow(doc, f"0/{branch}/1") == "move there"
    assert gallery.view(doc).flows[f"0/{branch}/1"].steps != ()
    gallery.do(act.RemoveIcons(doc, (branch, gallery.number(doc, "there", f"0/{branch}/1"))))
    assert gallery.flow(doc) == "grip"
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc, f"0/{branch}/1") == "move there"


def test_a_branch_fits_where_a_no_op_does(gallery):  # R-D13
    doc = gallery.begun("move")
    no = gallery.no(act.InsertBranch(doc, "0", gallery.number(doc, "move")))
    assert str(no.reason) == "a branch does not fit behind “move the joints”: it needs a Joint target"
    assert "2 to 32" in str(gallery.no(act.InsertBranch(doc, "0", 0, 1)).reason)


def test_several_targets_of_one_job_follow_each_other(gallery):  # R-D13
    doc = gallery.begun("arc", "there")
    assert gallery.flow(doc) == "arc there _"
    assert gallery.step(doc, "_").wants == ("Joint object",)
    gallery.do(act.InsertIcon(doc, "here", "0", gallery.number(doc, "there")))
    assert gallery.flow(doc) == "arc there here"
    gallery.do(act.RemoveIcons(doc, (gallery.number(doc, "there"),)))
    assert gallery.flow(doc) == "arc here _"


def test_every_kind_of_icon_can_be_inserted(gallery):  # R-D22
    for candidate in ONIKONS:
        doc = gallery.begun()
        if "object" in candidate.type:
            continue
        gallery.do(act.InsertIcon(doc, candidate.name))
        assert gallery.flow(doc).split()[0] == candidate.name
