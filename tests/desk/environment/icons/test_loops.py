import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from kit.desk.app_fixture import ONIKONS, AppFixture
from kit.examples import examples
from onika.desk.environment.icons.loops import for_pasting, tags
from onika.model.application import AppFlow, Icon
from onika.model.rules import loop
from onika.wire import act
from onika.words.fault import Place
from onika.words.reason import NOTHING


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def loops(gallery, doc):
    steps = gallery.application(doc).flows[0].steps
    return [
        f"{step.while_tag}{'!' * step.while_test}" if step.while_tag else "" for step in steps if isinstance(step, Icon)
    ]


def test_two_actions_are_marked_as_a_loop(gallery):  # R-D06, reading 23
    doc = gallery.begun("move", "there", "grip")
    tag = gallery.do(act.SetLoop(doc, gallery.number(doc, "grip"), gallery.number(doc, "there")))
    assert (tag, loops(gallery, doc)) == ("A", ["A", "", "A!"])
    assert str(gallery.view(doc).undo) == "looping from close the hand to move the joints"
    gallery.do(act.RemoveLoop(doc, gallery.number(doc, "move")))
    assert loops(gallery, doc) == ["", "", ""]
    assert "part of no loop" in str(gallery.no(act.RemoveLoop(doc, gallery.number(doc, "move"))).reason)


def test_a_loop_may_go_on_while_a_condition_holds(gallery):  # R-D13
    doc = gallery.begun("grip", "open")
    first, other = gallery.number(doc, "grip"), gallery.number(doc, "open")
    gallery.do(act.SetLoop(doc, first, other, condition="COUNT < 3"))
    assert (gallery.step(doc, "grip").loop_if, gallery.step(doc, "open").loop_if) == ("COUNT < 3", "")
    assert "condition" in gallery.no(act.SetLoop(doc, first, other, condition="never")).fields


def test_a_new_loop_replaces_those_that_its_actions_had(gallery):  # reading 23
    doc = gallery.begun("grip", "wait", "open")
    grip, wait, opened = (gallery.number(doc, name) for name in ("grip", "wait", "open"))
    gallery.do(act.SetLoop(doc, wait, grip))
    gallery.do(act.SetLoop(doc, opened, wait))
    assert loops(gallery, doc) == ["", "A", "A!"]


def test_loops_lie_within_each_other_and_never_cross(gallery):  # reading 23, R-X01
    doc = gallery.begun("grip", "wait", "open", "whole")
    first, two, three, four = (gallery.number(doc, name) for name in ("grip", "wait", "open", "whole"))
    gallery.do(act.SetLoop(doc, three, first))
    no = gallery.no(act.SetLoop(doc, four, two))
    assert str(no.reason) == "this loop would cross the loop A: one has to lie within the other"
    gallery.do(no.remedies[0].act)
    gallery.do(act.SetLoop(doc, four, two))
    gallery.do(act.RemoveLoop(doc, two))
    gallery.do(act.SetLoop(doc, four, first))
    assert gallery.do(act.SetLoop(doc, three, two)) == "B"


def test_what_is_no_loop_is_refused(gallery):  # reading 23
    doc = gallery.begun("move", "there", "grip", flows=2)
    gallery.add(doc, "open", flow="1")
    move, there = gallery.number(doc, "move"), gallery.number(doc, "there")
    assert "two actions" in str(gallery.no(act.SetLoop(doc, move, there)).reason)
    assert "one flow" in str(gallery.no(act.SetLoop(doc, move, gallery.number(doc, "open", "1"))).reason)
    assert "tag" in gallery.no(act.SetLoop(doc, move, gallery.number(doc, "grip"), "two words")).fields


def test_a_tag_that_is_taken_is_refused_and_a_free_one_offered(gallery):  # R-X01
    doc = gallery.begun("grip", "wait", "open", "whole")
    first, two, three, four = (gallery.number(doc, name) for name in ("grip", "wait", "open", "whole"))
    gallery.do(act.SetLoop(doc, two, first, "again"))
    no = gallery.no(act.SetLoop(doc, four, three, "again"))
    assert gallery.do(no.remedies[0].act) == "A"


@given(acts=st.lists(st.tuples(st.sampled_from(["loop", "remove", "delete"]), st.integers(0, 7), st.integers(0, 7))))
@settings(max_examples=examples(60), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_whatever_is_marked_the_loops_of_a_flow_are_well_formed(gallery, acts):  # reading 23
    doc = gallery.begun(*["grip", "wait"] * 4)
    syntax = gallery.environment.model.syntax
    for kind, first, other in acts:
        numbers = [step.number for step in gallery.application(doc).flows[0].steps]
        request = act.SetLoop(doc, numbers[first], numbers[other])
        gallery.answer(act.RemoveLoop(doc, numbers[first]) if kind == "remove" else request)
        assert loop.faults(gallery.application(doc).flows[0], syntax, NOTHING, Place("")) == ()


def test_half_a_loop_that_is_pasted_elsewhere_is_no_loop():
    half = Icon(ONIKONS[0], while_tag="A", while_test=True)
    assert tags(for_pasting([half], AppFlow(()))) == {}
    missing = AppFlow((Icon(ONIKONS[0], while_tag="A"),))
    assert tags(for_pasting([half], missing)) == {"A": [True]}
