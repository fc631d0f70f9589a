from dataclasses import replace

import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.show.application_view import ApplicationProjector
from onika.desk.environment.state.open_application import Judgement
from onika.wire import act
from onika.wire.view import FaultView
from onika.words.reason import Reason


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_flows_have_their_steps_and_the_edges_of_start_and_end(gallery):  # R-D04
    doc = gallery.begun("grip", flows=2)
    view = gallery.view(doc)
    assert [(flow.start, flow.end) for flow in view.flows.values()] == [("1", "1"), ("1", "1")]
    assert view.flows["0"].steps == (gallery.number(doc, "grip"),)
    assert (view.holes, view.is_running, view.is_judged) == (0, False, False)


def test_a_change_of_one_icon_leaves_the_others_the_same_objects(gallery):
    doc = gallery.begun("grip", "move", flows=2)
    gallery.add(doc, "open", flow="1")
    before = gallery.view(doc)
    gallery.do(act.InsertIcon(doc, "wait"))
    after = gallery.view(doc)
    assert after.flows["1"] is before.flows["1"]
    assert all(after.steps[number] is step for number, step in before.steps.items())


def test_a_mark_changes_no_flow(gallery):
    doc = gallery.begun("grip", "open")
    before = gallery.view(doc)
    gallery.do(act.SetSynchTag(doc, gallery.number(doc, "grip"), "A"))
    assert gallery.view(doc).flows["0"] is before.flows["0"]


def test_what_is_remembered_is_what_would_be_made_anew(gallery):
    doc = gallery.begun("grip", "arc", "there")
    branch = gallery.do(act.InsertBranch(doc))
    gallery.add(doc, "move", flow=f"0/{branch}/1")
    gallery.do(act.MoveIcons(doc, (branch,), "0", gallery.number(doc, "grip")))
    model = gallery.environment.model
    anew = ApplicationProjector().view(model.applications[doc], 0, model, is_running=False)
    assert anew == gallery.view(doc)
    assert anew.holes == 2


def test_nothing_of_a_closed_application_is_kept(gallery):
    doc = gallery.begun("grip")
    gallery.do(act.Close(doc, discards=True))
    projector = gallery.environment._projector
    assert doc not in projector._sights
    assert not any(doc in key for key in projector._made)


def test_an_insertion_is_sent_as_few_changes_however_many_icons_there_are(gallery):  # R-G07
    doc = gallery.begun(*["grip", "open", "wait"] * 20)
    sent = []
    gallery.environment.listeners.append(type("Page", (), {"patch": lambda _, patch: sent.append(patch)})())
    gallery.do(act.InsertIcon(doc, "whole"))
    places = {"/".join(path[2:3] or path) for path, _ in sent[0].changes}
    assert places <= {"flows", "steps", "undo", "redo", "is_dirty", "pictures"}
    assert len(sent[0].changes) <= 5


def test_one_fault_more_is_sent_as_one_whatever_stands_before_the_others(gallery):  # R-G07
    doc = gallery.begun("grip", "open")
    model = gallery.environment.model
    opened = model.applications[doc]

    def shown(*faults):
        judged = replace(opened, judgement=Judgement(opened.application, faults))
        return ApplicationProjector().view(judged, 0, model, is_running=False).faults

    near, twice, nowhere = (
        FaultView(Reason.plain("near"), step=1),
        FaultView(Reason.plain("near too"), step=1),
        FaultView(Reason.plain("nowhere")),
    )
    before, after = shown(near, twice, nowhere), shown(FaultView(Reason.plain("new"), step=2), near, twice, nowhere)
    assert len(before) == 3 and len(after) == 4
    assert before.items() <= after.items()
