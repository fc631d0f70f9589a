import pytest

from kit.desk.app_fixture import ONIKONS, AppFixture
from onika.desk.environment.icons.action_of_step import action_of, exchanged, unmarked
from onika.model.application import AppFlow, Icon


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


@pytest.mark.parametrize("name", ["arc", "there", "here", "_"])
def test_every_part_of_an_action_leads_to_it(gallery, name):  # R-D06, R-D13
    doc = gallery.begun("grip", "arc", "there", "here") if name != "_" else gallery.begun("grip", "arc", "there")
    opened = gallery.environment.model.applications[doc]
    acting = action_of(gallery.environment.model, opened, gallery.number(doc, name))
    assert (acting.path, acting.action.position) == ("0", 1)
    assert acting.having(Icon(ONIKONS[0])).steps[1].onikon.name == "grip"


def test_other_icons_take_their_places():
    first, other = Icon(ONIKONS[0]), Icon(ONIKONS[1])
    assert exchanged(AppFlow((first, first)), {1: other}).steps == (first, other)
    looped = Icon(ONIKONS[0], while_tag="A", while_test=True, while_if="A == 1", marker=True)
    assert unmarked([(3, looped)]) == {3: Icon(ONIKONS[0], marker=True)}
