"""What every test starts from: no state of this user's is read or written.

What all end with: whatever recordings tell of drives, the drives' table made it.
"""

import pytest


@pytest.fixture(autouse=True, scope="session")
def state(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
        yield


@pytest.fixture(autouse=True, scope="session")
def recordings(tmp_path_factory):
    """Every recording that the tests have made is replayed through the drives' table (R-X24)."""
    yield
    folder = tmp_path_factory.getbasetemp()
    if next(folder.rglob("*.mcap"), None) is not None:
        from kit.record.drive_replay import complaints_of_recordings

        assert list(complaints_of_recordings(folder)) == []
