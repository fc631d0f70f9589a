import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.application_entry import ApplicationNames, things
from onika.desk.environment.diary_entry import entries
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def line_of(gallery, request):
    """The line of an act, after it was carried out; names as they were known then."""
    doc = getattr(request, "doc", "")
    names = ApplicationNames()
    names.look(gallery.environment.model, (doc,))
    answer = gallery.answer(request)
    names.look(gallery.environment.model, (doc, str(answer.value)))
    return list(entries(request, answer, names.names)[0].columns(1.0)[1:])


def test_an_insertion_names_the_icon_and_what_it_was_put_behind(gallery):  # R-H01, §E.2
    doc = gallery.begun()
    assert line_of(gallery, act.InsertIcon(doc, "grip")) == ["insert_icon", "grip", "a1/1", "Start", "a1/0", "appl"]
    assert line_of(gallery, act.InsertIcon(doc, "open", "0", 1)) == [
        "insert_icon",
        "open",
        "a1/2",
        "grip",
        "a1/1",
        "appl",
    ]
    refused = line_of(gallery, act.InsertIcon(doc, "there", "0", 1))
    assert refused == ["try_insert_icon", "there", "there", "grip", "a1/1", "appl"]


def test_what_is_done_to_icons_names_them(gallery):  # R-H01
    doc = gallery.begun("grip", "open")
    first, two = gallery.number(doc, "grip"), gallery.number(doc, "open")
    ids = f"{doc}/{first},{doc}/{two}"
    assert line_of(gallery, act.SetBreakpoint(doc, (first, two)))[:3] == ["set_marker", "grip,open", ids]
    assert line_of(gallery, act.SetLoop(doc, two, first)) == ["set_whiletag", "open", "a1/2", "grip", "a1/1", "appl"]
    assert line_of(gallery, act.MoveIcons(doc, (first,), "0", two)) == [
        "move_icon",
        "grip",
        "a1/1",
        "open",
        "a1/2",
        "appl",
    ]
    gallery.do(act.CopyIcons(doc, (first, two)))
    assert line_of(gallery, act.PasteIcons(doc))[:3] == ["paste_icon", "open,grip", "a1/3,a1/4"]
    assert line_of(gallery, act.EditIcon(doc, first, "x")) == ["edit_icon", "grip", "a1/1", "Untitled-1", "a1", "appl"]
    assert line_of(gallery, act.RemoveIcons(doc, (first, two)))[:3] == ["delete_icon", "grip,open", ids]


def test_documents_of_both_kinds_are_told_apart(gallery):  # R-H01
    doc = gallery.begun("grip")
    assert line_of(gallery, act.Undo(doc)) == [
        "undo",
        "Untitled-1",
        "a1",
        "inserting close the hand",
        "desk.inserting",
        "appl",
    ]
    assert line_of(gallery, act.Save(doc, "mine"))[0] == "save_appl"
    assert line_of(gallery, act.Close(doc)) == ["close_appl", "mine", "a1", "none", "0", "appl"]
    assert line_of(gallery, act.Open("mine"))[:3] == ["try_open_conf", "mine", "0"]
    assert line_of(gallery, act.NewApplication()) == ["new_appl", "Untitled-1", "a2", "none", "0", "appl"]


def test_an_act_on_an_application_alone_is_about_that():
    assert things(act.AddFlow("a1"), "1", {}) is None
    assert things(act.Stop(), None, {}) is None


def test_of_what_is_gone_the_name_is_still_known_and_a_flow_is_read_once(gallery):  # R-H01, G07
    doc = gallery.begun("grip", "open")
    names, model = ApplicationNames(), gallery.environment.model
    names.look(model, (doc,))
    number = gallery.number(doc, "grip")
    gallery.do(act.RemoveIcons(doc, (number,)))
    names.look(gallery.environment.model, (doc,))
    assert names.names[f"{doc}/{number}"] == "grip"
    names.names[f"{doc}/{gallery.number(doc, 'open')}"] = "as it was read"
    names.look(gallery.environment.model, (doc,))
    assert "as it was read" in names.names.values()
