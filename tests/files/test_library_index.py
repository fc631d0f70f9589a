from dataclasses import replace
from datetime import date

import pytest
from hypothesis import given, strategies as st

from onika.files import library_index
from onika.files.library_index import IndexedFile, LibraryIndex, indexed_text, is_path
from onika.words.reason import Reason

INDEX = LibraryIndex(
    "cmu.puma",
    42,
    date(2026, 11, 22),
    date(2027, 2, 22),
    "SHA256:" + "k" * 43,
    "an arm",
    "77" * 32,
    5000,
    {
        "module/pd.rmod": indexed_text("module/pd.rmod", b"MODULE pd\nEOF\n"),
        "module/pd.py": IndexedFile("module/pd.py", 1834, "9f" * 32),
    },
)


def key(data: bytes) -> str:
    read = library_index.read(data)
    assert isinstance(read, Reason)
    return read.key


def test_an_index_is_read_as_it_was_written():  # R-X16
    assert library_index.read(library_index.write(INDEX)) == INDEX
    for other in (replace(INDEX, next_key=""), replace(INDEX, pack="", pack_size=0)):
        assert library_index.read(library_index.write(other)) == other


@given(st.binary(max_size=300), st.binary(max_size=300))
def test_whatever_a_file_holds_it_comes_back(one, other):  # R-X16
    files = {f"conf/{name}.conf": indexed_text(f"conf/{name}.conf", text) for name, text in (("a", one), ("b", other))}
    index = replace(INDEX, files=files)
    assert library_index.read(library_index.write(index)) == index


@given(st.data())
def test_no_altered_index_is_half_read(data):  # R-X16
    text = library_index.write(INDEX)
    at = data.draw(st.integers(0, len(text)))
    altered = text[:at] + data.draw(st.binary(max_size=8)) + text[at + data.draw(st.integers(0, 8)) :]
    read = library_index.read(altered)
    assert isinstance(read, Reason | LibraryIndex)
    if isinstance(read, LibraryIndex):
        assert all(is_path(path) for path in read.files)


def test_a_path_stands_once_and_is_no_folder_of_another():  # R-X16
    line = b"CODE robot/a 5 sha256:" + b"0" * 64 + b"\n"
    head = library_index.write(replace(INDEX, files={})).removesuffix(b"EOF\n")
    assert key(head + line + line + b"EOF\n") == "files.index_twice"
    assert key(head + line + line.replace(b"robot/a", b"robot/a/b") + b"EOF\n") == "files.index_twice"


def test_what_is_too_much_is_refused():  # R-X16
    head = library_index.write(replace(INDEX, files={})).removesuffix(b"EOF\n")
    large = b"CODE robot/a 10000001 sha256:" + b"0" * 64 + b"\nEOF\n"
    assert key(head + large) == "files.index_file_large"
    many = b"".join(b"TEXT conf/c%d.conf 0\n\n" % number for number in range(library_index.MOST_FILES + 1))
    assert key(head + many + b"EOF\n") == "files.index_many"


@pytest.mark.parametrize("cut", [b"EOF\n", b"UNTIL", b"2026-11-22", b"cmu.puma", b"sha256:"])
def test_what_lacks_a_part_is_no_index(cut):  # R-X16
    assert key(library_index.write(INDEX).replace(cut, b"", 1)).startswith("files.index_")


def test_nothing_stands_behind_the_end():  # R-X16
    assert key(library_index.write(INDEX) + b"\n") == "files.index_line"


def test_an_index_of_a_newer_format_is_told():  # R-X16
    assert key(library_index.write(INDEX).replace(b"ONIKA       1", b"ONIKA       2")) == "files.index_newer"


def test_meshes_may_lie_in_folders_of_their_own():  # R-F03
    assert is_path("robot/meshes/arm.stl") and is_path("net/a.onnx") and is_path("module/pd.es.toml")
    assert not is_path("module/meshes/pd.py") and not is_path("robot/.git/config") and not is_path("module")
