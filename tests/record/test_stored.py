import pytest

from onika.record.stored import StoredFile


@pytest.fixture
def stored(tmp_path):
    (tmp_path / "file").write_bytes(b"0123456789")
    return StoredFile(tmp_path / "file")


def test_any_part_of_it_is_read(stored):
    assert (stored.size, stored.read(0, 4), stored.read(8, 2)) == (10, b"0123", b"89")


def test_what_was_cut_off_meanwhile_is_told(stored, tmp_path):  # R-X05: a recording that is made anew
    with (tmp_path / "file").open("r+b") as other:
        other.truncate(5)
    assert stored.read(0, 5) == b"01234"
    with pytest.raises(ValueError, match="written over"):
        stored.read(4, 4)


def test_it_is_given_back_once(stored):
    stored.close()
    stored.close()
    with pytest.raises(ValueError, match="closed"):
        stored.read(0, 1)
