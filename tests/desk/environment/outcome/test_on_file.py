from dataclasses import replace

import pytest
from msgspec import structs

from kit.desk.app_fixture import AppFixture
from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.on_file import is_running
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.run import begun
from onika.desk.plan.preparation import prepare
from onika.store.site import open_site
from onika.wire import act
from onika.words.fault import Place


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def performed(gallery, doc, state="running"):
    """As if it ran: a run of something, of which only the document and the state matter here."""
    site = open_site([], {}, None)
    syntax, _ = site.syntax()
    application, _ = site.application("go_home", syntax)
    run = begun(
        doc, prepare(application, Place("x"), site, syntax).plan, 1, 0.0, StepMembership.of(application, syntax)
    )
    run = replace(run, view=structs.replace(run.view, state=state))
    gallery.environment.model = replace(gallery.environment.model, run=run)


def edits(doc, number):
    return [
        act.InsertIcon(doc, "grip"),
        act.InsertBranch(doc),
        act.SetConditions(doc, number, ()),
        act.ExchangeIcon(doc, number, "open"),
        act.RemoveIcons(doc, (number,)),
        act.MoveIcons(doc, (number,), "0", 0),
        act.CutIcons(doc, (number,)),
        act.PasteIcons(doc),
        act.EditIcon(doc, number, "x"),
        act.SetSynchTag(doc, number, "A"),
        act.SetLoop(doc, number, number),
        act.RemoveLoop(doc, number),
        act.AddFlow(doc),
        act.RemoveFlow(doc, "0"),
        act.SetParallel(doc, True),
        act.Undo(doc),
        act.Redo(doc),
        act.Reload(doc),
        act.Close(doc, discards=True),
    ]


def test_nothing_is_changed_while_it_runs_but_breakpoints(gallery):  # R-D18
    doc = gallery.begun("grip")
    number = gallery.number(doc, "grip")
    performed(gallery, doc)
    for edit in edits(doc, number):
        no = gallery.no(edit)
        assert "is running" in str(no.reason), edit
        assert [str(remedy.label) for remedy in no.remedies] == ["Abort the run", "Save a copy…"]
    gallery.do(act.SetBreakpoint(doc, (number,)))
    gallery.do(act.CopyIcons(doc, (number,)))
    gallery.do(act.Save(doc, "copy"))
    assert gallery.view(doc).is_running
    copy = list(gallery.environment.tree.applications)[-1]
    assert (gallery.view(doc).name, gallery.view(copy).name) == ("Untitled-1", "copy")
    gallery.do(act.InsertIcon(copy, "open"))


def test_another_one_and_one_whose_run_is_over_are_changed_as_ever(gallery):  # R-D18
    doc, other = gallery.begun("grip"), gallery.begun()
    performed(gallery, doc)
    gallery.do(act.InsertIcon(other, "grip"))
    performed(gallery, doc, "over")
    assert not is_running(gallery.environment.model, doc)
    gallery.do(act.InsertIcon(doc, "grip"))


def test_what_somebody_else_has_closed_is_told_by_every_act(gallery):
    others = [act.CopyIcons("a99", (1,)), act.SetBreakpoint("a99", (1,)), act.Keep("a99"), act.Check("a99")]
    for edit in [*edits("a99", 1), *others]:
        assert str(gallery.no(edit).reason) == "this application is no longer open", edit


ON_CONFIGURATIONS = (
    act.Place("c9", "a", 0, 0),
    act.Remove("c9", ("a",)),
    act.Move("c9"),
    act.Save("c9"),
    act.Close("c9"),
    act.Copy("c9", ("a",)),
    act.Check("c9"),
    act.Draft("c9"),
    act.Toggle("c9", "a"),
    act.Connect("c9"),
    act.Group("c9", "g", ("a",)),
    act.Rate("c9", "a", 1.0),
    act.Take("c9"),
)


@pytest.mark.parametrize("wish", ON_CONFIGURATIONS, ids=lambda wish: type(wish).__name__)
def test_an_act_on_a_configuration_that_was_closed_is_refused_in_one_sentence(tmp_path, wish):
    sitting = EnvironmentFixture(tmp_path)
    result = HANDLERS[type(wish)](sitting.environment.model, wish, sitting.surroundings)
    assert str(result.reason) == "this configuration is no longer open"
