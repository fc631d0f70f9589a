from pathlib import Path

from onika.files.text import decode, load


def test_a_byte_that_is_no_utf_8_is_named_with_its_line() -> None:
    text, (fault,) = decode(b"A 1\nB \xff\n", "f.rmod")  # R-B07
    assert text is None
    assert str(fault) == ("f.rmod:2: expected text in UTF-8, found the byte 0xff; instead: the file is left out")


def test_text_keeps_its_line_ends(tmp_path: Path) -> None:
    path = tmp_path / "a.rmod"
    path.write_bytes("é\r\nb\n".encode())
    assert load(path, "a.rmod") == ("é\r\nb\n", ())


def test_a_file_that_cannot_be_read_is_a_fault(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "missing"):
        text, (fault,) = load(path, "here")  # R-B07
        assert text is None
        assert (fault.place.file, fault.expected) == ("here", "a file that can be read")
