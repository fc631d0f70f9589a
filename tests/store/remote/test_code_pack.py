from dataclasses import replace
from hashlib import sha256

import zstandard

from kit.labs.library_server import LibraryServer
from kit.labs.library_site import TODAY, LibrarySite, taken
from onika.files.library_index import IndexedFile, LibraryIndex, indexed_text
from onika.store.remote.code_pack import packed, unpacked

FILES = {"module/b.py": b"# b\n", "module/a.py": b"# a\n" * 1000, "robot/arm.xml": b"<mujoco/>"}
PACK = packed(FILES)


def index_of(pack: bytes = PACK) -> LibraryIndex:
    files = {path: IndexedFile(path, len(text), sha256(text).hexdigest()) for path, text in FILES.items()}
    files["module/b.rmod"] = indexed_text("module/b.rmod", b"MODULE b\n")
    digest = sha256(pack).hexdigest()
    return LibraryIndex("wings", 1, TODAY, TODAY, pack=digest, pack_size=len(pack), files=files)


def test_a_pack_holds_every_file_that_the_index_does_not():  # R-F03
    assert unpacked(PACK, index_of()) == {sha256(text).hexdigest(): text for text in FILES.values()}
    assert packed({}) == b""


def test_a_pack_that_was_altered_gives_nothing():  # R-X16
    assert unpacked(PACK[:-1] + bytes([PACK[-1] ^ 1]), index_of()) == {}
    assert unpacked(b"", index_of()) == {}


def test_of_a_pack_that_holds_something_else_only_what_was_signed_is_taken():  # R-X16
    other = packed({**FILES, "module/b.py": b"# c\n"})
    assert set(unpacked(other, index_of(other))) == {sha256(FILES[path]).hexdigest() for path in FILES} - {
        sha256(b"# b\n").hexdigest()
    }


def test_a_pack_of_too_much_is_not_unpacked():  # R-X16
    bomb = zstandard.compress(b"x" * 10_000_000)
    assert unpacked(bomb, index_of(bomb)) == {}
    cut = PACK[: len(PACK) // 2]
    assert unpacked(cut, index_of(cut)) == {}


def test_many_files_come_in_one_request(tmp_path):  # R-F03
    site = LibrarySite(tmp_path)
    for number in range(40):
        site.write(f"module/m{number}.py", f"# {number}\n")
    site.publish()
    with LibraryServer(site.folder) as server:
        libraries = taken(tmp_path, site, server.address)
        server.asked.clear()
        library = libraries.listed()[0][0]
        assert not libraries.fetch(library)
        assert len(server.asked) == 1
        libraries.access.close()
    assert libraries.checkout(library).lacking() == ()


def test_without_a_good_pack_files_come_one_by_one(tmp_path):  # R-X16
    site = LibrarySite(tmp_path)
    for number in range(40):
        site.write(f"module/m{number}.py", f"# {number}\n")
    index = site.publish().index
    (site.folder / "objects" / index.pack).write_bytes(b"x" * index.pack_size)
    libraries = taken(tmp_path, site)
    library = libraries.listed()[0][0]
    assert not libraries.fetch(library)
    assert libraries.checkout(library).lacking() == ()
    assert replace(index, pack="") != index
