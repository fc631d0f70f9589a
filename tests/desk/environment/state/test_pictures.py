from kit.desk.dictionary_fixture import DictionaryFixture, plain
from onika.desk.environment.state.pictures import PictureSet, drawn, key_of
from onika.model.initials import drawn as initial
from onika.model.picture import blank, framed


def test_every_picture_is_sent_once_under_a_key_that_says_what_is_in_it(tmp_path):  # R-D01
    cabinet = DictionaryFixture(tmp_path, plain("a"), plain("b"))
    tree = cabinet.environment.tree
    assert cabinet.icon("a").picture == cabinet.icon("b").picture == key_of(blank())
    assert tree.pictures[key_of(blank())] == "".join(blank().rows)
    assert {len(picture) for picture in tree.pictures.values()} == {1024}
    assert {onikon.picture for onikon in tree.onikons.values()} | {"start", "end"} == set(tree.pictures)


def test_pictures_that_are_alike_have_one_key_and_others_have_others():
    assert drawn(framed(blank().rows)) == drawn(blank()) and key_of(initial("X")) != key_of(blank())


def test_where_nothing_is_new_it_is_the_same_album(tmp_path):
    album, model = PictureSet(), DictionaryFixture(tmp_path, plain("a")).environment.model
    assert PictureSet().shown((), {}, ("s", "e")) == {"start": "s", "end": "e"}
    pictures = album.shown(model.dictionaries, model.applications, model.flow_pictures)
    assert album.shown(model.dictionaries[:], {**model.applications}, model.flow_pictures) is pictures
    assert album.shown(model.dictionaries[1:], model.applications, model.flow_pictures) != pictures
