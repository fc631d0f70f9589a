import pytest


@pytest.fixture(autouse=True)
def _warm(warm_runtimes):
    """What an application does is the same on a runtime that is renewed."""
