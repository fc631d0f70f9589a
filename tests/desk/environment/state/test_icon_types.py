from kit.desk.dictionary_fixture import DictionaryFixture
from onika.desk.environment.state.icon_types import edges_of, role_of, type_views
from onika.desk.environment.state.model import Model
from onika.model.syntax import IconType


def test_a_type_is_what_the_words_of_its_name_say():  # R-D22
    roles = {
        "Application start": "start", "APPLICATION END": "end", "Complete nop": "nop", "Joint object": "target",
        "Weld job": "job", "Complete application": "application", "Job object": "target", "Nothing": "",
    }  # fmt: skip
    assert {name: role_of(IconType(name, 0, 0)) for name in roles} == roles
    assert role_of(None) == "" and edges_of(None) == ("", "") and edges_of(IconType("x", 3, 4)) == ("3", "4")


def test_every_type_of_the_definition_is_shown_with_its_edges_and_what_it_takes(tmp_path):  # R-D02
    types = DictionaryFixture(tmp_path).environment.tree.types
    assert list(types)[:3] == ["Application start", "Application end", "Complete job"]
    job, thing = types["Joint job"], types["Joint object"]
    assert (job.role, job.takes, job.right) == ("job", "Joint object", thing.left)
    assert types["Complete job"].takes == "" and [item.name for item in thing.items] == ["endpoint", "duration"]
    assert type_views(Model()) == {}
