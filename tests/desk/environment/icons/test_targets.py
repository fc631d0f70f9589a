import pytest

from kit.desk.dictionary_fixture import WHITE, DictionaryFixture, plain
from onika.wire import act

SECOND = (("1.5",),)
JOINTS = (("0", "0.1", "0.2", "0.3", "0.4", "0.5"), ("2",))


@pytest.fixture
def cabinet(tmp_path):
    return DictionaryFixture(tmp_path, plain("grip"), plain("rest", "Pause object", "", (1.0,)))


def made(name="nap", kind="Pause object", values=SECOND, picture=WHITE, **more):
    return act.MakeTarget(name, kind, values, picture, **more)


def test_a_target_is_written_into_the_users_own_dictionary_which_comes_into_being(cabinet):  # R-D08, R-X01
    assert not cabinet.own.path.exists()
    assert cabinet.do(made(description="for  a nap")) == "nap"
    view = cabinet.icon("nap")
    assert (view.type, view.role, view.values, view.description) == ("Pause object", "target", SECOND, "for a nap")
    assert view.dictionary == str(cabinet.own.path)
    assert list(cabinet.environment.tree.dictionaries)[1] == str(cabinet.own.path)  # before the shipped ones
    opened, faults = cabinet.own.open_onikon("nap", cabinet.environment.model.syntax)
    assert faults == () and opened.value.values == ((1.5,),)
    assert opened.value.picture.rows[0] == "8" * 32  # R-B11
    assert cabinet.site.onikon("nap", cabinet.environment.model.syntax)[0] == opened.value
    assert cabinet.look() == 0  # what was saved here is nothing new


def test_an_icon_that_does_nothing_is_made_too(cabinet):  # R-D08, R-D11
    cabinet.do(made("idle", "Complete NOP", (), base=str(cabinet.base.path)))
    assert cabinet.icon("idle").role == "nop" and cabinet.icon("idle").dictionary == str(cabinet.base.path)


def test_a_target_is_of_a_type_of_targets(cabinet):  # R-D08
    assert "Pause target" in str(cabinet.no(made(kind="Weld object")).fields["type"])
    assert "made of a configuration" in str(cabinet.no(made(kind="Joint job")).reason)
    assert "made of an application" in str(cabinet.no(made(kind="Joint application")).reason)


def test_values_are_typed_and_in_their_bounds_and_everything_wrong_is_told_at_once(cabinet):  # R-D08
    no = cabinet.no(made("9", "Joint object", (("0", "x", "0", "0", "0", "0"), ("1000",)), "7"))
    assert set(no.fields) == {"name", "endpoint[1]", "duration", "picture"}
    assert str(no.fields["duration"]) == "1000 is above 600 s"
    assert not cabinet.own.path.exists()


def test_a_name_is_unique_over_all_dictionaries(cabinet):  # R-D15, R-X01
    no = cabinet.no(made("grip", base=str(cabinet.own.path)))
    assert "lab has an icon grip" in str(no.reason) and list(no.fields) == ["name"]
    assert [str(remedy.label) for remedy in no.remedies] == ["Call it grip_2"]  # the other one comes first
    cabinet.do(no.remedies[0].act)
    assert cabinet.icon("grip_2").dictionary == str(cabinet.own.path)


def test_a_shipped_name_may_be_used_for_ones_own_where_that_is_meant(cabinet):  # R-D15
    no = cabinet.no(made("one_second"))
    assert [str(remedy.label) for remedy in no.remedies] == ["Call it one_second_2", "Use it in place of that one"]
    cabinet.do(no.remedies[1].act)
    assert cabinet.icon("one_second").values == SECOND
    generic = next(
        dictionary for dictionary in cabinet.environment.tree.dictionaries.values() if dictionary.name == "generic"
    )
    assert any("one_second" in str(fault) for fault in generic.faults)
    assert cabinet.site.onikon("one_second", cabinet.environment.model.syntax)[0].values == ((1.5,),)


def test_a_target_is_replaced_only_where_that_is_meant_and_an_action_never(cabinet):  # R-D15, R-B07
    path = cabinet.base.onikon_file("rest")
    path.write_text("# by hand\n" + path.read_text())
    no = cabinet.no(made("rest", base=str(cabinet.base.path)))
    assert "there already, a Pause target" in str(no.reason)
    cabinet.do(no.remedies[1].act)
    assert cabinet.icon("rest").values == SECOND and "# by hand" in path.read_text()
    no = cabinet.no(made("grip", base=str(cabinet.base.path), overwrites=True))
    assert "icon of the configuration" in str(no.reason) and [str(remedy.label) for remedy in no.remedies] == [
        "Call it grip_2"
    ]
    cabinet.base.onikon_file("bad").write_text("NONSENSE\nEOF\n")
    cabinet.look()
    no = cabinet.no(made("bad", base=str(cabinet.base.path)))
    assert "cannot be read" in str(no.reason)
    cabinet.do(no.remedies[1].act)
    assert cabinet.icon("bad").values == SECOND


def test_what_would_come_among_what_comes_with_onika_is_ones_own(cabinet):  # R-B07
    generic = next(
        dictionary.path for dictionary in cabinet.environment.tree.dictionaries.values() if dictionary.name == "generic"
    )
    cabinet.do(made(base=generic, overwrites=True))
    assert cabinet.icon("nap").dictionary == str(cabinet.own.path)


def test_where_it_cannot_be_written_the_reason_is_given(cabinet):  # R-B07
    cabinet.own.path.write_text("no folder")
    assert "cannot be saved" in str(cabinet.no(made()).reason)


def test_what_a_new_target_is_put_among_keeps_its_places(cabinet):  # R-D24
    def arranged():
        return cabinet.environment.tree.dictionaries[str(cabinet.own.path)].arranged

    cabinet.do(made("nap"))
    cabinet.do(made("zebra"))
    assert arranged() == ()  # by their names it is last
    cabinet.do(made("apple"))
    assert arranged() == ("nap", "zebra", "apple")
    cabinet.do(made("nap", values=(("2.5",),), overwrites=True))
    assert arranged() == ("nap", "zebra", "apple")


def test_a_target_keeps_the_arm_for_which_it_is_made(cabinet):  # R-D08
    cabinet.do(made("high", "Joint object", JOINTS, arm="puma_right"))
    assert cabinet.icon("high").arm == "puma_right"
    assert "ARM         puma_right" in cabinet.own.onikon_file("high").read_text()
    cabinet.do(act.EditOnikon("high", "up there"))
    assert cabinet.icon("high").arm == "puma_right"
    cabinet.do(made("idle", "Complete NOP", (), arm="puma"))
    assert cabinet.icon("idle").arm == ""
    assert set(cabinet.no(made("low", "Joint object", JOINTS, arm="no name")).fields) == {"arm"}
