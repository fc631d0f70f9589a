from kit.desk.app_fixture import onikon
from onika.desk.plan.icon_names import a_kind, kind_named, named, quoted, several, step_named
from onika.model.application import Branch, Hole, Icon
from onika.words.reason import in_language

THERE, BARE = onikon("there", "Joint object", "above triangle"), onikon("grip", "Complete job")


def test_an_icon_is_called_by_what_it_shows():
    assert (named(THERE), named(BARE), str(quoted(THERE))) == ("above triangle", "grip", "“above triangle”")
    names = [str(step_named(step)) for step in (Icon(THERE), Hole(), Branch(()))]
    assert names == ["above triangle", "a hole", "a branch"]


def test_several_icons_are_counted_and_holes_are_none():
    assert str(several([Icon(THERE)])) == "above triangle"
    assert str(several([Icon(BARE), Hole()])) == "grip"
    assert str(several([Icon(BARE), Hole(), Icon(THERE)])) == "2 icons"


def test_an_object_is_a_target_in_every_language():
    assert str(kind_named("Joint object")) == "Joint target"
    assert in_language(a_kind("Joint object"), "es") == "un objetivo Joint"


def test_another_type_is_called_as_it_is():
    assert [str(a_kind(kind)) for kind in ("Complete job", "Arm job", "object")] == [
        "a Complete job",
        "an Arm job",
        "an object",
    ]
