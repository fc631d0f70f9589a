import pytest

from onika.workcell.snapshot import Snapshot, decode, encode

SNAPSHOT = Snapshot("<mujoco/>", (0.1, -2.5), 3.5, True)


def test_a_snapshot_survives_its_bytes():
    assert decode(encode(SNAPSHOT)) == SNAPSHOT


def test_any_cut_of_its_bytes_is_refused():
    data = encode(SNAPSHOT)
    for length in range(len(data)):
        with pytest.raises(ValueError, match=r".+"):
            decode(data[:length])
