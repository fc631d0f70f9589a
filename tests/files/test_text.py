import os
import socket
from pathlib import Path

import pytest

from onika.files.text import LARGEST, decode, decode_foreign, load


def test_a_byte_that_is_no_utf_8_is_named_with_its_line() -> None:
    text, (fault,) = decode(b"A 1\nB \xff\n", "f.rmod")  # R-B07
    assert text is None
    assert str(fault) == ("f.rmod:2: expected text in UTF-8, found the byte 0xff; instead: the file is left out")


def test_text_keeps_its_line_ends(tmp_path: Path) -> None:
    path = tmp_path / "a.rmod"
    path.write_bytes("é\r\nb\n".encode())
    assert load(path, "a.rmod") == ("é\r\nb\n", ())


def test_a_file_that_cannot_be_read_is_a_fault(tmp_path: Path) -> None:
    for path, key in ((tmp_path, "files.unreadable_why"), (tmp_path / "missing", "files.unreadable")):
        text, (fault,) = load(path, "here")  # R-B07
        assert text is None
        assert (fault.place.file, fault.reason.key) == ("here", key)


def test_what_is_no_plain_file_is_a_fault_and_nothing_waits_for_it(tmp_path: Path) -> None:
    pipe, link, loop = tmp_path / "pipe", tmp_path / "link", tmp_path / "loop"  # R-B07
    os.mkfifo(pipe)
    link.symlink_to("/dev/zero")
    loop.symlink_to(loop)
    sentences = [str(load(path, "here")[1][0].reason) for path in (pipe, tmp_path, link, loop)]
    kinds = ("a pipe", "a directory", "a device", "Too many levels of symbolic links")
    assert sentences == [f"expected a file that can be read, found {kind}" for kind in kinds]
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(tmp_path / "s"))
        assert str(load(tmp_path / "s", "here")[1][0].reason) == "expected a file that can be read, found a socket"


def test_a_file_that_is_far_too_large_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "large"  # R-B07
    with path.open("wb") as file:
        file.truncate(LARGEST + 1)
    text, (fault,) = load(path, "here")
    assert text is None
    assert str(fault.reason) == "expected a file that can be read, found 25165825 bytes, more than 25165824"


def test_a_large_file_and_one_that_a_link_leads_to_are_read(tmp_path: Path) -> None:
    path = tmp_path / "large"
    path.write_text("é" * 5_000_000)
    (tmp_path / "link").symlink_to(path)
    assert load(tmp_path / "link", "here") == ("é" * 5_000_000, ())


@pytest.mark.parametrize("foreign", ["a\nb\n".encode("utf-16"), b"\xef\xbb\xbfa\nb\n", b"a\rb\r", b"a\nb\n"])
def test_a_log_that_another_system_has_written_is_the_same_text(foreign: bytes) -> None:  # R-H08
    assert decode_foreign(foreign, "x.log") == ("a\nb\n", ())


def test_what_is_no_letter_in_a_log_is_named_and_the_rest_read() -> None:  # R-H08
    text, (fault,) = decode_foreign(b"a\nb\xf1\n", "x.log")
    assert (text, fault.place.line) == ("a\nb\ufffd\n", 2)
