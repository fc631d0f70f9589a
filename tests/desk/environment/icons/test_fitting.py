import pytest

from kit.desk.app_fixture import ONIKONS, AppFixture, onikon as made
from onika.desk.environment.icons.fitting import fitting_behind, misfit, onikon
from onika.desk.environment.outcome.outcome import No
from onika.model.application import AppFlow, Icon
from onika.store.base_directory import BaseDirectory
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_whatever_is_offered_fits_and_whatever_fits_is_counted(gallery):  # R-X01
    for before in ("move", "slide", "grip", "arc"):
        for wish in ONIKONS:
            doc = gallery.begun(before)
            insertion = act.InsertIcon(doc, wish.name, "0", gallery.number(doc, before))
            no = gallery.answer(insertion).no
            if no is None:
                continue
            assert 1 <= len(no.remedies) <= 4, insertion
            for remedy in no.remedies:
                assert remedy.show or gallery.answer(remedy.act).no is None, remedy
                if remedy.act:
                    gallery.do(act.Undo(doc))


def test_icons_that_the_application_uses_already_come_first(gallery):  # R-X01
    doc = gallery.begun("move", "there", "visit")
    no = gallery.no(act.InsertIcon(doc, "grip", "0", gallery.number(doc, "visit")))
    assert str(no.remedies[0].label) == "Use above triangle"


def test_icons_of_a_dictionary_that_is_in_use_come_before_those_of_others(tmp_path):  # R-X01
    far = BaseDirectory(tmp_path / "far")
    far.save_onikon(made("follow", "Cartesian job", "along the hill"))
    gallery = AppFixture(tmp_path / "near", before=(far,))
    doc = gallery.begun("move", "there")
    no = gallery.no(act.InsertIcon(doc, "spot", "0", gallery.number(doc, "there")))
    assert [str(remedy.label) for remedy in no.remedies[:2]] == [
        "First insert move on a straight line, then it", "First insert along the hill, then it",
    ]  # fmt: skip


def test_the_icon_of_a_name_is_that_of_the_dictionaries(gallery):
    assert onikon(gallery.environment.model, "grip").description == "close the hand"
    assert isinstance(onikon(gallery.environment.model, "nobody"), No)


def test_a_type_that_stands_in_no_flow_is_told(gallery):  # R-D04
    doc = gallery.begun()
    model = gallery.environment.model
    no = misfit(model, model.applications[doc], AppFlow(()), -1, Icon(made("odd", "Strange object")), path="0")
    assert str(no.reason) == "“odd” is a Strange target, which stands in no flow"


def test_what_fits_behind_an_icon_has_its_edge(gallery):
    model = gallery.environment.model
    names = {candidate.name for candidate in fitting_behind(model, model.syntax.find("Joint job"), ())}
    assert names == {"there", "here"}


def test_to_a_target_that_comes_too_early_its_job_is_offered(gallery):  # R-X01
    doc = gallery.begun("grip")
    grip = gallery.number(doc, "grip")
    no = gallery.no(act.InsertIcon(doc, "spot", "0", grip))
    assert str(no.reason) == "a Cartesian target does not fit behind “close the hand”: an action comes next"
    assert str(no.remedies[0].label) == "First insert move on a straight line, then it"
    number = gallery.do(no.remedies[0].act)
    assert gallery.flow(doc) == "grip slide spot"
    assert number == gallery.number(doc, "spot")
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == "grip"


def test_what_is_moved_or_pasted_too_early_is_not_put_behind_a_new_job(gallery):  # R-X01
    doc = gallery.begun("grip", "slide", "spot")
    no = gallery.no(act.MoveIcons(doc, (gallery.number(doc, "spot"),), "0", gallery.number(doc, "grip")))
    assert all(remedy.act is None for remedy in no.remedies)


def test_a_target_at_another_one_of_the_same_edges_may_take_its_place(gallery):  # R-X01
    doc = gallery.begun("move", "there")
    there = gallery.number(doc, "there")
    first = gallery.no(act.InsertIcon(doc, "here", "0", there)).remedies[0]
    assert str(first.label) == "Replace above triangle"
    gallery.do(first.act)
    assert gallery.flow(doc) == "move here"


def test_a_target_of_other_edges_takes_no_place(gallery):  # R-X01
    doc = gallery.begun("move", "there")
    no = gallery.no(act.InsertIcon(doc, "spot", "0", gallery.number(doc, "there")))
    assert not any(str(remedy.label).startswith("Replace") for remedy in no.remedies)
