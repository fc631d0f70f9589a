from onika.cli.library.listing_text import changed, entry, is_fingerprint
from onika.files.library_lock import Agreement
from onika.store.remote.contents import LibraryEntry
from onika.store.remote.library_changes import LibraryChanges


def test_a_long_list_is_cut_and_says_by_how_much():  # R-F06
    paths = tuple(f"module/m{number:02}.py" for number in range(25))
    lines = [str(line) for line in changed("wings", LibraryChanges(1, 2, added=paths))]
    assert lines[0] == "wings: version 2 after 1"
    assert lines[1].endswith("module/m19.py, (+5)")


def test_what_is_written_further_is_said_task_by_task():  # R-X16
    new = LibraryChanges(1, 2, altered=("module/a.rmod",), further={"a": Agreement(frozenset({"X", "Y"}))})
    assert "  a would further write or touch X and Y" in [str(line) for line in changed("wings", new)]


def test_what_is_new_has_a_mark():  # R-F06
    assert str(entry(LibraryEntry("p", "task", "wink", "winks", is_new=True))) == "+ task wink: winks"


def test_a_fingerprint_is_known_by_its_form():  # R-X16
    assert is_fingerprint("SHA256:" + "a" * 43)
    assert not is_fingerprint("MD5:ab") and not is_fingerprint("SHA256:" + "a" * 44)
