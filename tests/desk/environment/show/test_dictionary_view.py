from dataclasses import replace

from kit.desk.dictionary_fixture import DictionaryFixture, plain
from onika.desk.environment.show.dictionary_view import dictionary_views, onikon_views
from onika.desk.environment.state.model import Model


def test_an_icon_is_shown_with_all_that_a_page_needs_of_it(tmp_path):  # R-D01, R-D08
    cabinet = DictionaryFixture(tmp_path, plain("arc", "Joint job"), plain("nap", "Pause object", "a nap", (1.5,)))
    arc, nap = cabinet.icon("arc"), cabinet.icon("nap")
    assert (arc.role, arc.left, arc.right, arc.takes) == ("job", "1", "2", ("Joint object",))
    assert (nap.role, nap.description, nap.values, nap.order) == ("target", "a nap", (("1.5",),), 1)
    assert nap.path == str(cabinet.base.onikon_file("nap"))
    assert cabinet.icon("jmove_viaC").takes == ("Joint object", "Joint object")
    assert cabinet.environment.tree.dictionaries[cabinet.icon("noop").dictionary].is_shipped


def test_what_looks_as_it_did_is_the_same_object(tmp_path):
    cabinet = DictionaryFixture(tmp_path, plain("grip"), plain("open"))
    before = cabinet.environment.tree
    cabinet.base.save_onikon(plain("grip", description="close"), overwrites=True)
    cabinet.look()
    after = cabinet.environment.tree
    assert after.onikons["open"] is before.onikons["open"] and after.onikons["grip"] is not before.onikons["grip"]
    assert after.types is before.types and after.pictures == before.pictures


def test_without_a_syntax_there_are_no_icons(tmp_path):  # R-B07
    model = replace(DictionaryFixture(tmp_path).environment.model, syntax=None)
    assert onikon_views(model, {}) == {} and dictionary_views(Model()) == {}
