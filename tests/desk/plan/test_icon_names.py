from kit.app_fixture import onikon
from onika.desk.plan.icon_names import a, in_words, kind_named, listed, named, quoted, several, step_named
from onika.model.application import Branch, Hole, Icon

THERE, BARE = onikon("there", "Joint object", "above triangle"), onikon("grip", "Complete job")


def test_an_icon_is_called_by_what_it_shows():
    assert (named(THERE), named(BARE), quoted(THERE)) == ("above triangle", "grip", "“above triangle”")
    names = [str(step_named(step)) for step in (Icon(THERE), Hole(), Branch(()))]
    assert names == ["above triangle", "a hole", "a branch"]


def test_several_icons_are_counted_and_holes_are_none():
    assert several([Icon(THERE)]) == "above triangle"
    assert several([Icon(BARE), Hole()]) == "grip"
    assert str(several([Icon(BARE), Hole(), Icon(THERE)])) == "2 icons"


def test_objects_are_targets_in_words():
    assert kind_named("Joint object") == "Joint target"
    assert (a("Joint target"), a("Open job")) == ("a Joint target", "an Open job")


def test_names_stand_in_a_sentence():
    assert (listed(["a"]), listed(["a", "b"]), listed(["a", "b", "c"])) == ("a", "a and b", "a, b and c")


def test_types_within_a_sentence_are_in_words_and_things_stay_things():
    text = "expected a joint object or two Pause objects, found the object of an Object store"
    assert in_words(text) == "expected a joint target or two Pause targets, found the object of an Object store"
