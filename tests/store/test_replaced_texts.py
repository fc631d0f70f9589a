import stat
from pathlib import Path

import pytest

from onika.files import whole
from onika.store.replaced_texts import FOLDER, MOST, ReplacedTexts
from onika.words.fault import Refusal


def test_what_was_replaced_is_listed_newest_first_and_found_by_its_number(tmp_path: Path) -> None:  # R-X10
    texts = ReplacedTexts(tmp_path / "state")
    assert texts.listed() == () and texts.find(1) is None
    for number in (1, 2):
        assert texts.keep(Path("/base/module/pd.py"), f"text {number}\r\n\u00e9", float(number)) is None
    assert [(text.number, text.text) for text in texts.listed()] == [(2, "text 2\r\n\u00e9"), (1, "text 1\r\n\u00e9")]
    first = texts.find(1)
    assert first is not None and (first.path, first.moment_s) == ("/base/module/pd.py", 1.0)
    assert stat.S_IMODE((tmp_path / "state" / FOLDER).stat().st_mode) == 0o700


def test_the_last_hundred_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:  # R-X10
    monkeypatch.setattr("os.fsync", lambda _descriptor: None)
    texts = ReplacedTexts(tmp_path)
    for number in range(MOST + 3):
        texts.keep(Path("/x"), str(number), 0.0)
    assert len(list((tmp_path / FOLDER).iterdir())) == MOST
    assert [text.text for text in texts.listed()][:1] == [str(MOST + 2)] and texts.listed()[-1].text == "3"


def test_two_programs_keep_texts_at_a_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:  # R-X10
    here, elsewhere = ReplacedTexts(tmp_path), ReplacedTexts(tmp_path)
    numbers = ReplacedTexts._numbers

    def late(texts: ReplacedTexts) -> list[int]:
        taken = numbers(texts)
        if texts is here:
            elsewhere.keep(Path("/x"), "theirs", 0.0)
        return taken

    monkeypatch.setattr(ReplacedTexts, "_numbers", late)
    assert here.keep(Path("/x"), "mine", 0.0) is None
    monkeypatch.undo()
    assert [text.text for text in here.listed()] == ["mine", "theirs"]


@pytest.mark.parametrize("content", ["", "[]", "{", '{"path": 1}', "null", "\x00"])
def test_what_is_no_kept_text_is_left_out(tmp_path: Path, content: str) -> None:  # R-B07
    texts = ReplacedTexts(tmp_path)
    texts.keep(Path("/x"), "good", 0.0)
    for name in ("00000002.json", "junk.json", "notes.txt", "\u0664.json"):
        (tmp_path / FOLDER / name).write_text(content)
    assert [text.text for text in texts.listed()] == ["good"]


def test_a_full_disk_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:  # R-B07
    def full(*_given: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(whole, "_write_new", full)
    refused = ReplacedTexts(tmp_path).keep(Path("/x"), "text", 0.0)
    assert isinstance(refused, Refusal) and "space" in str(refused.reason)
    assert list((tmp_path / FOLDER).iterdir()) == []
