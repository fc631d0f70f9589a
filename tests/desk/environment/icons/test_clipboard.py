import pytest

from kit.desk.app_fixture import AppFixture
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def numbers(gallery, doc, *names):
    return tuple(gallery.number(doc, name) for name in names)


def test_icons_are_copied_within_and_between_applications(gallery):  # R-D05
    first, other = gallery.begun("move", "there", "grip"), gallery.begun("wait")
    gallery.do(act.CopyIcons(first, numbers(gallery, first, "move", "there")))
    assert str(gallery.environment.tree.icon_clipboard) == "2 icons"
    pasted = gallery.do(act.PasteIcons(other, "0", gallery.number(other, "wait")))
    assert gallery.flow(other) == "wait move there"
    assert [gallery.view(other).steps[str(number)].name for number in pasted] == ["move", "there"]
    gallery.do(act.PasteIcons(first))
    assert gallery.flow(first) == "move there move there grip"
    assert str(gallery.view(first).undo) == "pasting 2 icons"


def test_the_text_travels_by_mail(gallery):  # R-D05, R-D14
    first, other = gallery.begun("move", "there"), gallery.begun()
    gallery.do(act.SetBreakpoint(first, numbers(gallery, first, "move"), condition="LAMP == 1"))
    text = gallery.do(act.CopyIcons(first, numbers(gallery, first, "move", "there")))
    gallery.do(act.PasteIcons(other, text="\n " + text.replace("\n", "\r\n") + "\n"))
    assert gallery.flow(other) == "move there"
    assert gallery.step(other, "move").break_if == "LAMP == 1"
    assert gallery.step(other, "there").values == gallery.step(first, "there").values


def test_holes_open_where_what_is_pasted_does_not_fit(gallery):  # R-D05, R-D19
    doc = gallery.begun("move", "there", "slide", "spot", "grip")
    gallery.do(act.CopyIcons(doc, numbers(gallery, doc, "move", "slide", "grip")))
    other = gallery.begun("open")
    gallery.do(act.PasteIcons(other))
    assert gallery.flow(other) == "move _ slide _ grip open"
    assert gallery.view(other).holes == 2


def test_pasting_is_all_or_nothing(gallery):  # R-D03, R-X01
    doc = gallery.begun("move", "there", "grip")
    gallery.do(act.CopyIcons(doc, numbers(gallery, doc, "there", "grip")))
    no = gallery.no(act.PasteIcons(doc, "0", gallery.number(doc, "grip")))
    expected = "nothing is pasted: a Joint target does not fit behind “close the hand”: an action comes next"
    assert str(no.reason) == expected
    assert no.remedies


def test_cut_is_one_step_and_what_was_cut_can_be_pasted(gallery):  # R-D05, R-X10
    doc = gallery.begun("grip", "open")
    text = gallery.do(act.CutIcons(doc, numbers(gallery, doc, "grip")))
    assert (gallery.flow(doc), str(gallery.view(doc).undo)) == ("open", "cutting close the hand")
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == "grip open"
    assert len(gallery.do(act.PasteIcons(doc, text=text))) == 1


@pytest.mark.parametrize("text", ["x", "VERSION 9.9\nEOF\n", "FLOW\nENDFLOW\n", "\0", "{}"])
def test_a_text_that_is_none_is_refused_with_the_reason(gallery, text):  # R-D05
    doc = gallery.begun()
    assert str(gallery.no(act.PasteIcons(doc, text=text)).reason).startswith("this is no text of icons: the text")


def test_a_text_of_several_flows_or_of_none_is_refused(gallery):
    doc = gallery.begun()
    flow = "FLOW\nENDFLOW\n"
    assert "2 flows" in str(gallery.no(act.PasteIcons(doc, text=f"{flow}{flow}EOF\n")).reason)
    assert str(gallery.no(act.PasteIcons(doc, text=f"{flow}EOF\n")).reason) == "nothing was copied yet"
    assert str(gallery.no(act.PasteIcons(doc)).reason) == "nothing was copied yet"
    gallery.add(doc, "move")
    assert str(gallery.no(act.CopyIcons(doc, numbers(gallery, doc, "_"))).reason) == "a hole cannot be copied"


def test_a_copied_loop_gets_a_tag_of_its_own_and_half_a_loop_is_none(gallery):  # R-D06, reading 23
    doc = gallery.begun("grip", "wait", "open")
    test, anchor = numbers(gallery, doc, "open", "grip")
    gallery.do(act.SetLoop(doc, test, anchor))
    gallery.do(act.CopyIcons(doc, (test, anchor)))
    first, last = gallery.do(act.PasteIcons(doc, "0", test))
    steps = gallery.view(doc).steps
    assert (steps[str(first)].loop, steps[str(last)].loop) == ("B", "B")
    assert (steps[str(first)].is_test, steps[str(last)].is_test) == (False, True)
    gallery.do(act.CopyIcons(doc, (test,)))
    (alone,) = gallery.do(act.PasteIcons(doc))
    assert gallery.view(doc).steps[str(alone)].loop == ""


def test_half_a_loop_that_was_cut_makes_it_whole_again(gallery):  # R-D06
    doc = gallery.begun("grip", "wait", "open")
    test, anchor = numbers(gallery, doc, "open", "grip")
    gallery.do(act.SetLoop(doc, test, anchor))
    gallery.do(act.CutIcons(doc, (anchor,)))
    (back,) = gallery.do(act.PasteIcons(doc, "0", gallery.number(doc, "wait")))
    assert gallery.view(doc).steps[str(back)].loop == "A"


def test_a_branch_is_copied_with_what_is_in_it_under_new_numbers(gallery):  # R-D13
    doc = gallery.begun()
    branch = gallery.do(act.InsertBranch(doc))
    gallery.add(doc, "grip", flow=f"0/{branch}/0")
    gallery.do(act.CopyIcons(doc, (branch, gallery.number(doc, "grip", f"0/{branch}/0"))))
    (copy,) = gallery.do(act.PasteIcons(doc, "0", branch))
    assert gallery.flow(doc, f"0/{copy}/0") == "grip"
    assert gallery.number(doc, "grip", f"0/{copy}/0") != gallery.number(doc, "grip", f"0/{branch}/0")


def test_it_is_told_what_was_copied(gallery):  # R-D05
    doc = gallery.begun("move", "there", "grip", "wait", "open", "slide")
    steps = {name: gallery.number(doc, name) for name in ("move", "there", "grip", "wait", "open", "slide")}
    gallery.do(act.CopyIcons(doc, (steps["grip"],)))
    assert str(gallery.says[-1].text).startswith("copied: close the hand; Paste puts it behind")
    gallery.do(act.CopyIcons(doc, tuple(steps.values())))
    assert "close the hand, " in str(gallery.says[-1].text)
    assert "and 2 more; Paste puts them behind" in str(gallery.says[-1].text)


def test_behind_a_job_alone_is_behind_its_targets_where_an_action_is_pasted(gallery):  # R-D05
    doc = gallery.begun("grip", "move", "there", "open")
    gallery.do(act.CopyIcons(doc, (gallery.number(doc, "grip"),)))
    gallery.do(act.PasteIcons(doc, "0", gallery.number(doc, "move")))
    assert gallery.flow(doc) == "grip move there grip open"


def test_behind_a_job_that_lacks_its_target_that_is_pasted_into_its_hole(gallery):  # R-D05, R-D19
    doc = gallery.begun("move", "there", "visit", flows=2)
    gallery.do(act.CopyIcons(doc, (gallery.number(doc, "there"),)))
    gallery.do(act.PasteIcons(doc, "0", gallery.number(doc, "visit")))
    assert gallery.flow(doc) == "move there visit there"
