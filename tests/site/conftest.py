import pytest

from kit.runtime.warm_runtimes import WarmRuntimes
from onika.desk.run import run, survey


@pytest.fixture(scope="session")
def kept_runtimes():
    """Those that tests may use one after the other."""
    kept = WarmRuntimes()
    yield kept
    kept.close()


@pytest.fixture
def warm_runtimes(kept_runtimes, monkeypatch):
    """Runs in virtual time and looks at files take a runtime that was used before, and is renewed."""
    monkeypatch.setattr(run, "LaunchedRuntime", kept_runtimes)
    monkeypatch.setattr(survey, "LaunchedRuntime", kept_runtimes)
