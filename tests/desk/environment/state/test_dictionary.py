from kit.desk.dictionary_fixture import plain
from onika.desk.environment.state.dictionary import find, has_dictionary, home_of, open_dictionaries
from onika.store.base_directory import BaseDirectory
from onika.store.site import open_site

SYNTAX, _ = open_site([], {}, None).syntax()
PAUSE = plain("second", "Pause object", "for a second", (1.0,))


def base_with(path, *onikons):
    base = BaseDirectory(path)
    for onikon in onikons:
        base.save_onikon(onikon)
    return base


def test_icons_are_grouped_by_type_in_the_order_of_the_syntax(tmp_path):  # R-D01
    base = base_with(tmp_path, PAUSE, plain("b"), plain("a"), plain("odd", "Weld job"), plain("whole", "Complete NOP"))
    (dictionary,) = open_dictionaries([base], SYNTAX)
    assert list(dictionary.onikons) == ["a", "b", "whole", "second", "odd"]


def test_a_later_icon_of_a_name_is_not_added_and_is_told(tmp_path):  # R-D15
    near, far = base_with(tmp_path / "one", plain("grip")), base_with(tmp_path / "two", plain("grip"), plain("open"))
    first, second = open_dictionaries([near, far], SYNTAX)
    assert (list(first.onikons), list(second.onikons)) == (["grip"], ["open"])
    (fault,) = second.faults
    assert fault.is_note and fault.place.file == str(far.onikon_file("grip")) and str(near.path) in str(fault.reason)
    assert find((first, second), "grip").path == near.onikon_file("grip")
    assert home_of((first, second), "open") is second and home_of((first, second), "none") is None


def test_what_is_at_fault_or_of_an_unknown_target_type_is_left_out_and_told(tmp_path):  # R-B07, R-D16
    base = base_with(tmp_path, plain("grip"), plain("weld", "Weld job"), plain("spark", "Weld object"))
    base.onikon_file("bad").write_text("NONSENSE\nEOF\n")
    (tmp_path / "dict" / "9.onk").write_text("")
    (tmp_path / "conf").mkdir()
    (tmp_path / "conf" / "9.conf").write_text("")
    (dictionary,) = open_dictionaries([base], SYNTAX)
    assert list(dictionary.onikons) == ["grip", "weld"]
    faults = {fault.place.file.rpartition("/")[2] for fault in dictionary.faults}
    assert faults == {"bad.onk", "spark.onk", "weld.onk", "9.onk"}  # the job acts as a complete one, which is a note


def test_only_what_has_changed_is_read_again_and_what_is_as_it_was_is_the_same(tmp_path):  # R-C01
    base = base_with(tmp_path, PAUSE, plain("grip"))
    former = open_dictionaries([base], SYNTAX)
    assert open_dictionaries([base], SYNTAX, former, frozenset([base.onikon_file("grip")]))[0] is former[0]
    base.save_onikon(plain("grip", description="close"), overwrites=True)
    assert open_dictionaries([base], SYNTAX, former)[0] is former[0]
    (dictionary,) = open_dictionaries([base], SYNTAX, former, frozenset([base.onikon_file("grip")]))
    assert dictionary.onikons["grip"].value.description == "close"
    assert dictionary.onikons["second"] is former[0].onikons["second"]
    base.onikon_file("grip").unlink()
    assert list(open_dictionaries([base], SYNTAX, (dictionary,))[0].onikons) == ["second"]


def test_a_base_directory_has_a_dictionary_where_it_has_a_folder_of_that_name(tmp_path):  # R-B08
    assert not has_dictionary(BaseDirectory(tmp_path))
    (tmp_path / "dict").mkdir()
    assert has_dictionary(BaseDirectory(tmp_path))
    assert open_dictionaries([BaseDirectory(tmp_path)], SYNTAX)[0].onikons == {}
