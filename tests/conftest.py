"""What every test starts from: no state of this user's is read or written."""

import pytest


@pytest.fixture(autouse=True, scope="session")
def state(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
        yield
