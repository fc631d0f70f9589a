"""Module code that does not return while it is loaded is interrupted."""

import signal

import pytest

from onika.host.loading.load_alarm import LoadAlarm
from onika.runtime.error import ModuleError


@pytest.fixture
def alarm():
    former = signal.getsignal(signal.SIGALRM)
    yield LoadAlarm(0.02)
    signal.signal(signal.SIGALRM, former)


def test_a_loop_is_interrupted(alarm):  # law 21, R-X12
    with pytest.raises(ModuleError), alarm.watch():
        while True:
            pass


def test_a_library_that_is_imported_may_take_longer(alarm, tmp_path, monkeypatch):  # law 21
    (tmp_path / "slow_library.py").write_text("for _ in range(3_000_000): pass\n")
    monkeypatch.syspath_prepend(tmp_path)
    with alarm.watch():
        import slow_library  # type: ignore[import-not-found]
    assert slow_library


def test_nothing_is_interrupted_when_loading_is_over(alarm):  # law 21
    with alarm.watch():
        pass
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
