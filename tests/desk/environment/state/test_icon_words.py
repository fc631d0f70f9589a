from dataclasses import replace

from kit.desk.dictionary_fixture import DictionaryFixture, plain
from onika.desk.environment.state.icon_words import for_placing, forgotten, told_again, words_of

SPOKEN = replace(plain("grip", description="close the hand"), words=(("es", "cierra la mano"),))


def test_a_placed_icon_takes_the_words_of_its_dictionary_as_long_as_it_says_the_same(tmp_path):  # R-X11, R-D05
    cabinet = DictionaryFixture(tmp_path, SPOKEN)
    model = cabinet.environment.model
    placed = for_placing(SPOKEN)
    assert placed.words == () and for_placing(placed) is placed
    assert words_of(model, placed) == {"es": "cierra la mano"}
    assert words_of(model, replace(placed, description="hold it")) == {}
    assert words_of(model, replace(placed, name="other")) == {}
    assert words_of(model, replace(placed, words=(("es", "agarra"),))) == {"es": "agarra"}
    assert cabinet.icon("grip").words == {"es": "cierra la mano"}


def test_an_icon_that_says_something_else_says_nothing_in_other_languages():  # R-X11
    assert told_again(SPOKEN, "close the hand") == SPOKEN.words
    assert told_again(SPOKEN, "hold it") == ()
    assert told_again(replace(SPOKEN, description="close  the hand"), "close the hand") == SPOKEN.words
    gone = "what grip said in other languages (es) is gone, for it says something else now"
    assert str(forgotten(SPOKEN, "hold it")) == gone
    assert not forgotten(SPOKEN, "close the hand") and not forgotten(plain("grip"), "hold it")


def test_every_shipped_icon_speaks_spanish(tmp_path):  # R-X11
    icons = DictionaryFixture(tmp_path).environment.tree.onikons
    assert [name for name, icon in icons.items() if not icon.words.get("es")] == []
