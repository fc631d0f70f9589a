import pytest

from kit.desk.dictionary_fixture import DictionaryFixture, plain
from onika.desk.environment.icons.dictionaries import in_order, is_icon
from onika.store.base_directory import BaseDirectory
from onika.wire import act


@pytest.fixture
def cabinet(tmp_path):
    return DictionaryFixture(tmp_path, plain("grip"), plain("open"))


def far(tmp_path, *onikons):
    base = BaseDirectory(tmp_path / "far")
    for onikon in onikons:
        base.save_onikon(onikon)
    return base


def test_every_base_directory_of_the_search_path_with_a_dictionary_is_open(cabinet):  # R-D01
    tree = cabinet.environment.tree
    assert [dictionary.name for dictionary in tree.dictionaries.values()][:2] == ["lab", "boxes"]
    assert [dictionary.order for dictionary in tree.dictionaries.values()] == list(range(len(tree.dictionaries)))
    lab = tree.dictionaries[str(cabinet.base.path)]
    assert (lab.onikons, lab.is_shipped, lab.faults) == (2, False, ())


def test_another_dictionary_is_opened_by_its_base_directory_or_its_folder(cabinet, tmp_path):  # R-D01, R-D15
    base = far(tmp_path, plain("grip"), plain("weld"))
    assert cabinet.do(act.OpenDictionary(str(base.path / "dict"))) == str(base.path)
    assert list(cabinet.environment.tree.dictionaries)[-1] == str(base.path)
    assert cabinet.icon("weld").dictionary == str(base.path)
    assert cabinet.icon("grip").dictionary == str(cabinet.base.path)
    assert "grip" in str(cabinet.environment.tree.dictionaries[str(base.path)].faults[0])
    assert "grip" in str(cabinet.says[-1].text)
    revision = cabinet.environment.revision
    assert cabinet.do(act.OpenDictionary(str(base.path))) == str(base.path)
    assert cabinet.environment.revision == revision


def test_what_is_no_dictionary_is_refused_with_what_could_be_opened(cabinet, tmp_path):  # R-X01
    assert "there is no" in str(cabinet.no(act.OpenDictionary(str(tmp_path / "none"))).fields["path"])
    base = far(tmp_path)
    (tmp_path / "all" / "inner" / "dict").mkdir(parents=True)
    no = cabinet.no(act.OpenDictionary(str(tmp_path / "all")))
    assert "no dictionary" in str(no.reason)
    assert no.remedies[0].act == act.OpenDictionary(str(tmp_path / "all" / "inner"))
    (tmp_path / "file").write_text("")
    assert "no directory" in str(cabinet.no(act.OpenDictionary(str(tmp_path / "file"))).reason)
    assert "cannot be opened" in str(cabinet.no(act.OpenDictionary("~nobody-of-that-name/x")).reason)
    assert not base.path.exists()


def test_a_dictionary_that_closes_gives_its_names_to_later_ones(cabinet, tmp_path):  # R-D15
    base = far(tmp_path, plain("grip", description="theirs"))
    cabinet.do(act.OpenDictionary(str(base.path)))
    cabinet.do(act.CloseDictionary(str(cabinet.base.path)))
    assert cabinet.icon("grip").description == "theirs"
    assert cabinet.environment.tree.dictionaries[str(base.path)].faults == ()
    assert "not open" in str(cabinet.no(act.CloseDictionary(str(cabinet.base.path))).reason)
    cabinet.do(act.OpenDictionary(str(cabinet.base.path)))  # it stands where the search path has it
    assert cabinet.icon("grip").dictionary == str(cabinet.base.path)


def test_files_that_others_write_are_in_the_dictionary_with_the_next_look(cabinet):  # R-D01, R-C01
    cabinet.base.save_onikon(plain("weld"))
    assert cabinet.look() == 1
    assert cabinet.names == ["grip", "open", "weld"]
    cabinet.base.onikon_file("weld").write_text("NONSENSE\nEOF\n")
    cabinet.look()
    assert cabinet.names == ["grip", "open"]
    assert {say.level for say in cabinet.says} == {"warning"} and "weld" in str(cabinet.says[0].text)
    cabinet.base.onikon_file("weld").unlink()
    cabinet.look()
    assert cabinet.environment.tree.dictionaries[str(cabinet.base.path)].faults == ()
    assert cabinet.look() == 0


def test_only_files_in_a_dict_folder_are_icons():  # R-B08
    from pathlib import Path

    assert is_icon(Path("/a/dict/b.onk"))
    assert not is_icon(Path("/a/conf/b.onk")) and not is_icon(Path("/a/dict/b.conf"))


def test_a_dictionary_stands_where_the_search_path_has_it(cabinet, tmp_path):  # R-D01
    model = cabinet.environment.model
    assert [dictionary.path.name for dictionary in in_order(model, cabinet.own, cabinet.site)][:3] == [
        "lab",
        "onika",
        "boxes",
    ]
    assert in_order(model, far(tmp_path), cabinet.site)[-1].path.name == "far"


def test_a_dictionary_that_others_make_on_the_search_path_is_opened_and_a_closed_one_stays_closed(cabinet):  # R-D01
    cabinet.own.save_onikon(plain("mine"))
    cabinet.look()
    assert cabinet.icon("mine").dictionary == str(cabinet.own.path)
    cabinet.do(act.CloseDictionary(str(cabinet.base.path)))
    cabinet.base.save_onikon(plain("weld"))
    cabinet.look()
    assert cabinet.names == ["mine"]
