"""What every test starts from: no state of this user's, and nothing that he has fetched, is read or written.

What all end with: whatever recordings tell of drives, the drives' table made it.
"""

import gc
import socket

import pytest
from hypothesis import settings

_BY_TEXT = {"page", "site", "slow"}
"""The marks whose tests are wanted alone, by the commands of `make`; each file says in its text which it bears."""

# Where the examples are the same every time, fewer will do, but not for what no mutant shall survive.
settings.register_profile("mutation", settings.get_profile("ci"))
settings.register_profile("ci", settings.get_profile("ci"), max_examples=15)


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    """A worker asks at once how often its next test has failed: else TCP would hold the question back, 40 ms a test."""
    if "sock_port" in getattr(config, "workerinput", ()):
        config.failures_db.sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)


def pytest_ignore_collect(collection_path, config):
    """Leaves out, unread, what bears none of the marks that are wanted: to import every test takes half a minute."""
    wanted = config.getoption("markexpr").partition(" and ")[0].strip("()").split(" or ")
    if set(wanted) <= _BY_TEXT and collection_path.suffix == ".py":
        text = collection_path.read_text(encoding="utf-8")
        return not any(f"mark.{mark}" in text for mark in wanted) or None
    return None


def pytest_collection_finish():
    """What was collected stays to the end: whoever looks for garbage need not look through it again and again."""
    gc.collect()
    gc.freeze()


@pytest.fixture(autouse=True, scope="session")
def state(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.fixture(scope="session")
def kept_runtimes():
    """Those that tests may use one after the other."""
    from kit.runtime.warm_runtimes import WarmRuntimes

    kept = WarmRuntimes()
    yield kept
    kept.close()


@pytest.fixture
def idle_starts(monkeypatch):
    """The starts of runtimes for `onika run`, of which nothing comes up."""
    from kit.link.idle_start import IdleStart
    from onika.cli import run

    monkeypatch.setattr(run, "RuntimeStart", IdleStart)
    monkeypatch.setattr(IdleStart, "begun", [])
    return IdleStart.begun


@pytest.fixture
def warm_runtimes(kept_runtimes, idle_starts, monkeypatch):
    """Runs in virtual time and looks at files take a runtime that was used before, and is renewed."""
    from onika.desk.run import run, survey

    monkeypatch.setattr(run, "LaunchedRuntime", kept_runtimes)
    monkeypatch.setattr(survey, "LaunchedRuntime", kept_runtimes)


@pytest.fixture(autouse=True, scope="session")
def recordings(tmp_path_factory):
    """Every recording that the tests have made is replayed through the drives' table (R-X24)."""
    yield
    folder = tmp_path_factory.getbasetemp()
    if next(folder.rglob("*.mcap"), None) is not None:
        from kit.record.drive_replay import complaints_of_recordings

        assert list(complaints_of_recordings(folder)) == []
