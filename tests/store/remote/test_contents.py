from kit.labs.library_site import TODAY, wink
from onika.files.library_index import LibraryIndex, indexed_text
from onika.store.remote.contents import contents, matching

PICTURE = "PICT        " + "8" * 32 + "\n"
ICON = "VERSION 1.3\nONIKON Complete job\nDESC        wink twice\n" + PICTURE * 32 + "EOF\n"
TEXTS = {
    "module/wink.rmod": wink("LAMP", says="a lamp that winks"),
    "module/wink.py": "",
    "conf/winkC.conf": "VERSION 1.3\nEOF\n",
    "dict/winkC.onk": ICON,
    "appl/evening.appl": "VERSION 1.3\nDESC  at home\nEOF\n",
    "world/hall.world": "VERSION 2.0\nEOF\n",
    "world/hall.xml": "<mujoco/>",
}
FILES = {path: indexed_text(path, text.encode()) for path, text in TEXTS.items()}
INDEX = LibraryIndex("wings", 1, TODAY, TODAY, files=FILES)


def test_everything_that_can_be_chosen_is_named_with_its_words():  # R-F06
    shown = {(entry.kind, entry.name): entry for entry in contents(INDEX, frozenset({"appl/evening.appl"}))}
    assert sorted(shown) == [
        ("application", "evening"),
        ("configuration", "winkC"),
        ("icon", "winkC"),
        ("task", "wink"),
        ("world", "hall"),
    ]
    assert shown["task", "wink"].description == "a lamp that winks"
    assert shown["task", "wink"].writes == ("LAMP",)
    assert shown["application", "evening"].is_new and not shown["task", "wink"].is_new
    assert shown["application", "evening"].description == ""


def test_a_configuration_has_the_picture_and_the_words_of_its_icon():  # R-F06
    entry = next(entry for entry in contents(INDEX) if entry.kind == "configuration")
    assert entry.rows == ("8" * 32,) * 32
    assert entry.description == "wink twice"


def test_a_picture_that_is_none_is_not_shown():  # R-X16
    for wrong in (ICON.replace("8" * 32, "<b>"), ICON.replace(PICTURE, "", 1), ICON.replace("8" * 32, "9" * 32, 1)):
        files = {"dict/x.onk": indexed_text("dict/x.onk", wrong.encode())}
        assert contents(LibraryIndex("w", 1, TODAY, TODAY, files=files))[0].rows == ()


def test_what_has_all_words_is_found():  # R-F06
    assert [entry.kind for entry in matching(contents(INDEX), "WINK lamp")] == ["task"]
    assert len(matching(contents(INDEX), "")) == 5
    assert matching(contents(INDEX), "nothing such") == ()
