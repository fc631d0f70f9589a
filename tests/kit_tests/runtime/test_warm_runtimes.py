"""Runtimes that tests use one after the other: the same as new ones, and kept only while they are."""

import pytest

from kit.runtime.warm_runtimes import WarmRuntimes
from onika.desk.run.run import start_on
from onika.desk.run.settings import RunSettings
from onika.desk.trial.account import timed_events
from onika.store.site import open_site

pytestmark = pytest.mark.site

SITE = open_site([], {}, None)


@pytest.fixture
def kept():
    kept = WarmRuntimes()
    yield kept
    kept.close()


def hash_of_a_run(launch):
    settings = RunSettings("go_home", is_virtual=True)
    with launch as runtime, start_on(lambda *_: runtime, settings, SITE) as running:
        for _ in timed_events(running, 60.0):
            pass
        return running.result().hash


def pid(launch):
    with launch as runtime:
        return runtime.pid


def test_a_runtime_that_was_used_does_the_same_again(kept):  # R-X23
    first, second = (hash_of_a_run(kept(("rt0",), True, False)) for _ in range(2))
    assert first == second
    assert pid(kept(("rt0",), True, False)) == pid(kept(("rt0",), True, False))


def test_what_is_asked_for_otherwise_or_ended_badly_is_another_runtime(kept, monkeypatch):  # R-X23
    first = pid(kept(("rt0",), True))
    assert pid(kept(("rt0", "rt1"), True)) != first
    monkeypatch.setenv("ANYTHING", "else")
    assert pid(kept(("rt0",), True)) != first
    monkeypatch.undo()
    with pytest.raises(KeyError), kept(("rt0",), True):
        raise KeyError
    assert pid(kept(("rt0",), True)) != first
