import signal
from types import ModuleType

import pytest

from onika.host.guards import code_watch as room
from onika.host.guards.code_guard import CodeGuard
from onika.host.guards.code_watch import GAVE_UP, CodeWatch


class Unit:
    """A process that looks at one function of ours."""

    def __init__(self):
        self.ours = ModuleType("onika.pretended")
        self.ours.step = lambda: None
        self.said = []
        self.looked = 0
        self.codes = []
        self.watch = CodeWatch(CodeGuard([self.ours]), self.said.append, self._note, self.codes.append)

    def _note(self):
        self.looked += 1


@pytest.fixture
def unit():
    former = signal.getsignal(signal.SIGALRM)
    yield Unit()
    signal.setitimer(signal.ITIMER_REAL, 0.0)
    signal.signal(signal.SIGALRM, former)


def test_a_process_whose_code_is_its_own_goes_on(unit):  # law 14
    unit.watch.look()
    assert (unit.said, unit.codes, unit.looked) == ([], [], 1)


def test_one_whose_code_was_replaced_says_what_and_ends(unit):  # law 14, law 30
    exec("def step(): ...", space := {"__name__": "onika_task_sick"})
    unit.ours.step = space["step"]
    unit.watch.look()
    assert str(unit.said[0]) == "module sick has replaced onika.pretended.step, on which the runtime relies"
    assert unit.codes == [GAVE_UP]


def test_where_nobody_can_be_named_it_says_that_it_was_module_code(unit):
    unit.ours.step = 7
    unit.watch.look()
    assert str(unit.said[0]) == "module code has replaced onika.pretended.step, on which the runtime relies"


def test_it_looks_by_itself_whatever_runs(unit, monkeypatch):  # law 30
    monkeypatch.setattr(room, "EVERY_S", 0.005)
    unit.watch.begin()
    while unit.looked < 4:
        pass


def test_without_the_signal_the_loop_looks_every_two_seconds(unit, monkeypatch):  # law 30
    now = [room.monotonic_ns()]
    monkeypatch.setattr(room, "monotonic_ns", lambda: now[0])
    unit.watch.look_if_due()
    assert unit.looked == 0
    now[0] += 3_000_000_000
    unit.watch.look_if_due()
    unit.watch.look_if_due()
    assert unit.looked == 1


def test_a_fault_that_replaced_code_has_led_to_is_told_as_that(unit):  # law 14, law 15
    with pytest.raises(KeyError), unit.watch.blaming():
        exec("def step(): ...", space := {"__name__": "onika_task_sick"})
        unit.ours.step = space["step"]
        raise KeyError("rt0")
    assert (len(unit.said), unit.codes) == (1, [GAVE_UP])


def test_any_other_fault_is_told_as_it_is(unit):  # law 15
    with pytest.raises(KeyError), unit.watch.blaming():
        raise KeyError("rt0")
    assert (unit.said, unit.codes) == ([], [])
