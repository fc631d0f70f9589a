import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from kit.desk.app_fixture import ONIKONS, AppFixture
from kit.examples import examples
from onika.desk.environment.outcome.on_file import syntax_of
from onika.desk.environment.show.application_view import ApplicationProjector
from onika.model.flow_path import flows_by_path, spots
from onika.model.rules.jigsaw import misfits
from onika.wire import act
from onika.words.reason import NOTHING


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_undo_after_undo_comes_to_the_beginning_and_redo_to_the_end(gallery):  # R-X10
    doc = gallery.begun("move", "there", "grip")
    number = gallery.number(doc, "grip")
    gallery.do(act.SetBreakpoint(doc, (number,)))
    gallery.do(act.RemoveIcons(doc, (number,)))
    end, labels = gallery.view(doc), []
    while gallery.view(doc).undo:
        labels.append(gallery.view(doc).undo)
        gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == ""
    assert list(map(str, labels[:2])) == ["deleting close the hand", "setting a breakpoint after close the hand"]
    assert str(gallery.no(act.Undo(doc)).reason) == "there is nothing to take back"
    while gallery.view(doc).redo:
        gallery.do(act.Redo(doc))
    assert gallery.view(doc).flows == end.flows
    assert gallery.view(doc).steps == end.steps
    assert str(gallery.no(act.Redo(doc)).reason) == "there is nothing to do again"


def test_what_is_done_after_undo_leaves_nothing_to_redo(gallery):  # R-X10
    doc = gallery.begun("grip", "open")
    gallery.do(act.Undo(doc))
    gallery.do(act.InsertIcon(doc, "wait"))
    assert gallery.view(doc).redo == NOTHING


def edit(gallery, doc, kind, first, other, name):
    """An act on what is there now; any of them may be refused."""
    every = spots(gallery.application(doc))
    numbers = [0, *every]
    first, last = numbers[first % len(numbers)], numbers[other % len(numbers)]
    path = every[last].path if last else "01"[other % 2]
    match kind:
        case "insert":
            return act.InsertIcon(doc, name, path, last)
        case "branch":
            return act.InsertBranch(doc, path, last)
        case "remove":
            return act.RemoveIcons(doc, (first, last))
        case "move":
            return act.MoveIcons(doc, (first,), path, last)
        case "exchange":
            return act.ExchangeIcon(doc, first, name)
        case "cut":
            return act.CutIcons(doc, (first, last))
        case "paste":
            return act.PasteIcons(doc, path, last)
        case "mark":
            return act.SetBreakpoint(doc, (first,))
        case "loop":
            return act.SetLoop(doc, first, last)
        case "flow":
            return act.AddFlow(doc, first)
    return act.Undo(doc)


EDITS = ["insert", "insert", "insert", "branch", "remove", "move", "exchange", "cut", "paste", "flow"]
KINDS = [*EDITS, "mark", "loop", "undo"]
places, names = st.integers(0, 40), st.sampled_from([onikon.name for onikon in ONIKONS])
deeds = st.lists(st.tuples(st.sampled_from(KINDS), places, places, names), max_size=25)


@given(deeds)
@settings(max_examples=examples(100), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_whatever_is_done_flows_fit_numbers_are_unique_and_undo_leads_back(gallery, deeds):  # R-D03, R-D05, R-X10
    doc = gallery.begun(flows=2)
    beginning = gallery.application(doc)
    for deed in deeds:
        gallery.answer(edit(gallery, doc, *deed))
        model, application = gallery.environment.model, gallery.application(doc)
        numbers = [step.number for _, flow in flows_by_path(application) for step in flow.steps]
        assert 0 not in numbers
        assert len(set(numbers)) == len(numbers)
        assert max(numbers, default=0) <= gallery.environment.model.applications[doc].last_number
        for _, flow in flows_by_path(application):
            assert misfits(flow, syntax_of(gallery.environment.model)) == ()
        seen = ApplicationProjector().view(model.applications[doc], gallery.view(doc).order, model, is_running=False)
        assert gallery.view(doc) == seen, "what is remembered is what would be made anew"
    while gallery.view(doc).undo:
        gallery.do(act.Undo(doc))
    assert gallery.application(doc) == beginning
    gallery.do(act.Close(doc, discards=True))


def test_two_browsers_at_one_flow_converge(gallery):  # issue: two browsers editing one flow
    doc = gallery.begun("grip", "open")
    grip, opened = gallery.number(doc, "grip"), gallery.number(doc, "open")
    mine = gallery.answer(act.InsertIcon(doc, "wait", "0", opened), "me")
    yours = gallery.answer(act.InsertIcon(doc, "whole", "0", grip), "you")
    assert mine.no is None
    assert yours.no is None
    assert gallery.flow(doc) == "grip whole open wait", "each stands behind what it was meant for"
    gallery.answer(act.RemoveIcons(doc, (grip,)), "you")
    late = gallery.answer(act.InsertIcon(doc, "wait", "0", grip), "me")
    assert late.no is not None
    assert gallery.flow(doc) == "whole open wait"
    seen = gallery.copy["applications"][doc]["flows"]["0"]["steps"]
    assert list(seen) == list(spots(gallery.application(doc))), "the copy of a page is what is here"
