from pathlib import Path

from onika.store.opened_text import OpenedText, open_file, put, save
from onika.words.fault import Fault, Place, Refusal
from onika.words.reason import Reason

FAULT = Fault(Place("f"), Reason.plain("expected a, found b"), Reason.plain("c"))


def read(text: str, name: str, place: str) -> tuple[str | None, tuple[Fault, ...]]:
    return (None, (FAULT,)) if text == "bad" else (f"{name} {text}", ())


def write(value: str, former: str) -> str:
    return former + value


def test_what_is_opened_has_the_text_it_was_read_from(tmp_path: Path) -> None:
    path = tmp_path / "a"  # R-B07
    path.write_text("one")
    assert open_file(path, "a", read) == (OpenedText("a one", path, "one"), ())
    path.write_text("bad")
    assert open_file(path, "a", read) == (None, (FAULT,))
    opened, (fault,) = open_file(tmp_path / "b", "b", read)
    assert (opened, str(fault.reason)) == (None, "expected a file that can be read, found No such file or directory")


def test_what_is_saved_goes_over_what_was_opened_and_over_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "new" / "a"  # R-B07
    opened = save(path, "1", write, None, overwrites=False)
    assert opened == OpenedText("1", path, "1")
    assert isinstance(save(path, "2", write, None, overwrites=False), Refusal)
    assert isinstance(opened, OpenedText)
    assert save(path, "2", write, opened, overwrites=False) == OpenedText("2", path, "12")
    assert isinstance(save(path, "3", write, opened, overwrites=False), Refusal)
    assert save(path, "3", write, opened, overwrites=True) == OpenedText("3", path, "123")


def test_a_copy_under_another_name_keeps_the_comments_and_replaces_nothing(tmp_path: Path) -> None:
    opened = OpenedText("1", tmp_path / "a", "# mine ")  # R-B01
    assert save(tmp_path / "b", "1", write, opened, overwrites=False) == OpenedText("1", tmp_path / "b", "# mine 1")
    assert isinstance(save(tmp_path / "b", "1", write, opened, overwrites=False), Refusal)


def test_no_directory_is_a_refusal(tmp_path: Path) -> None:
    (tmp_path / "x").touch()
    refusal = put(tmp_path / "x" / "a", "1", "1", "")
    assert isinstance(refusal, Refusal)
    assert "cannot be saved" in str(refusal.reason)
