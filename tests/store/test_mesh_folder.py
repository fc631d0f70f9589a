import gzip
import os

import pytest

from onika.store.mesh_folder import MeshFolder

FIRST, OTHER, THIRD = "0" * 32, "f" * 32, "12" * 16


def test_what_is_kept_is_there_from_then_on_and_for_nobody_else(tmp_path):  # R-X19
    folder = MeshFolder(tmp_path / "state")
    assert folder.lacking([FIRST, OTHER]) == [FIRST, OTHER]
    folder.keep({FIRST: b"mesh"})
    assert gzip.decompress(folder.packed(FIRST)) == b"mesh"
    assert folder.lacking([FIRST, OTHER]) == [OTHER]
    assert folder.packed(OTHER) is None
    assert folder.there([OTHER, FIRST]) == [FIRST]
    (file,) = (tmp_path / "state" / "meshes").iterdir()
    assert (file.stat().st_mode & 0o77, file.parent.stat().st_mode & 0o77) == (0, 0)


@pytest.mark.parametrize("name", ["", "../token", "0" * 31, "0" * 33, "G" * 32, "0" * 32 + "\n"])
def test_nothing_else_is_read_under_a_name_that_is_none(tmp_path, name):
    folder = MeshFolder(tmp_path)
    folder.keep({FIRST: b"mesh"})
    (tmp_path / "token.gz").write_text("secret")
    assert folder.packed(name) is None
    assert folder.lacking([name]) == folder.there([name]) == []


def test_of_too_many_those_go_that_were_asked_for_longest_ago(tmp_path):
    folder = MeshFolder(tmp_path)
    content = {name: os.urandom(1000) for name in (FIRST, OTHER, THIRD)}
    for age, name in enumerate((FIRST, OTHER)):
        folder.keep({name: content[name]})
        os.utime(tmp_path / "meshes" / f"{name}.gz", (age + 1, age + 1))
    assert folder.packed(FIRST)
    folder.keep({THIRD: content[THIRD]}, most_bytes=2200)
    assert folder.lacking([FIRST, OTHER, THIRD]) == [OTHER]
