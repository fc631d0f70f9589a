import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.icons.alteration import flow_at
from onika.desk.environment.show.step_view import step_views
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def edges(gallery, doc):
    views = gallery.view(doc)
    return [(views.steps[str(number)].left, views.steps[str(number)].right) for number in views.flows["0"].steps]


def test_icons_show_the_edges_of_their_types_and_holes_those_they_need(gallery):  # R-D03
    doc = gallery.begun("move", "there", "slide")
    assert edges(gallery, doc) == [("1", "2"), ("2", "1"), ("1", "3"), ("3", "1")]
    hole = gallery.step(doc, "_")
    assert (hole.kind, hole.wants, hole.is_joined) == ("hole", ("Cartesian object",), True)
    assert gallery.step(doc, "there").is_joined
    assert not gallery.step(doc, "slide").is_joined


def test_a_target_that_is_not_the_last_of_its_action_has_the_edge_of_the_next(gallery):  # R-D13
    doc = gallery.begun("arc", "there")
    assert edges(gallery, doc) == [("1", "2"), ("2", "2"), ("2", "1")]
    gallery.do(act.RemoveIcons(doc, (gallery.number(doc, "there"),)))
    assert gallery.step(doc, "_").wants == ("Joint object", "Joint object")


def test_an_icon_shows_what_it_is(gallery):  # R-D20, R-X11
    doc = gallery.begun("move", "there")
    view = gallery.step(doc, "there")
    assert (view.role, view.type, view.description) == ("target", "Joint object", "above triangle")
    assert view.values == (("0.1", "0.2", "0.3", "0.4", "0.5", "0.6"), ("1.5",))
    assert len(gallery.environment.tree.pictures[view.picture]) == 1024


def test_where_a_job_is_missing_a_hole_wants_no_target(gallery):  # R-D19
    doc = gallery.begun("move", "there")
    gallery.do(act.RemoveIcons(doc, (gallery.number(doc, "move"),)))
    hole = gallery.step(doc, "_")
    assert (hole.wants, hole.is_joined, hole.left, hole.right) == ((), False, "1", "2")


def test_marks_are_shown_where_they_are_set(gallery):  # R-D06
    doc = gallery.begun("grip", "open")
    grip, opened = gallery.number(doc, "grip"), gallery.number(doc, "open")
    gallery.do(act.SetLoop(doc, opened, grip, condition="LAMP == 1"))
    gallery.do(act.SetSynchTag(doc, grip, "B"))
    gallery.do(act.SetBreakpoint(doc, (grip,), condition="LAMP == 0"))
    view = gallery.step(doc, "grip")
    assert (view.breaks, view.break_if, view.synch_tag, view.loop) == (True, "LAMP == 0", "B", "A")
    view = gallery.step(doc, "open")
    assert (view.is_test, view.loop_if) == (True, "LAMP == 1")


def test_what_stands_as_it_did_is_the_same_object(gallery):
    doc = gallery.begun("grip", "move", "there")
    model, flow = gallery.environment.model, flow_at(gallery.application(doc), "0")
    views = step_views(flow, "0", model, {})
    again = step_views(flow, "0", model, views)
    assert all(again[number] is view for number, view in views.items())
