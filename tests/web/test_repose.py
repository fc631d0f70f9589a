import asyncio
from dataclasses import replace
from types import SimpleNamespace

import pytest

from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.state.live import SubsystemFacts, TaskFacts
from onika.desk.environment.state.model import Model
from onika.web.repose import ALONE_S, UNTOUCHED_S, Repose, is_at_work
from onika.wire import act


class Runtime:
    def __init__(self):
        self.rests = False

    def rest(self):
        self.rests = True

    def wake(self):
        self.rests = False


@pytest.fixture
def now():
    return [0.0]


@pytest.fixture
def runtime():
    return Runtime()


@pytest.fixture
def repose(runtime, now):
    return Repose(runtime, lambda: now[0])


ALONE, VISITED = Model(), Model(people=1)


def with_task(state):
    """A model in which a task of a configuration is in a state."""
    facts = SubsystemFacts("main", "live", {"a": TaskFacts(state)})
    return replace(ALONE, documents={"d1": SimpleNamespace(live=facts), "d2": SimpleNamespace(live=None)})


def test_whoever_leaves_a_page_untouched_finds_it_awake_with_the_first_act(repose, runtime, now):  # R-X25
    now[0] = UNTOUCHED_S - 1.0
    repose.look(VISITED)
    assert not runtime.rests
    now[0] = UNTOUCHED_S
    repose.look(VISITED)
    assert runtime.rests and repose.goes_on
    repose.begun(act.Undo("d1"), "me")
    assert not runtime.rests and not repose.goes_on


def test_a_seat_without_a_page_reposes_soon_and_wakes_with_the_page(repose, runtime, now):  # R-X25
    repose.changed(VISITED, ALONE)
    now[0] = ALONE_S
    repose.look(ALONE)
    assert runtime.rests
    repose.changed(ALONE, VISITED)
    assert not runtime.rests


def test_patience_begins_anew_when_an_act_has_ended(repose, runtime, now):
    end = repose.begun(act.Undo("d1"), "me")
    now[0] = UNTOUCHED_S
    end(ActAnswer())
    repose.look(VISITED)
    assert not runtime.rests


def test_what_runs_keeps_it_awake_however_long(repose, runtime, now):  # R-X25
    busy = with_task("ON")
    repose.changed(ALONE, busy)
    now[0] = 1e6
    repose.look(busy)
    assert not runtime.rests
    repose.look(ALONE)
    assert runtime.rests
    repose.changed(ALONE, busy)
    assert not runtime.rests


@pytest.mark.parametrize(("state", "is_busy"), [("OFF", False), ("ERROR", False), ("ON", True), ("SPAWNING", True)])
def test_tasks_by_hand_are_work_but_those_that_only_live_are_none(state, is_busy):
    assert is_at_work(with_task(state)) is is_busy


def test_in_repose_pauses_are_long_and_end_with_it(repose, now):  # R-X25
    async def play():
        await repose.pause(0.0)
        now[0] = UNTOUCHED_S
        repose.look(VISITED)
        pausing = asyncio.create_task(repose.pause(3600.0))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        assert not pausing.done()
        repose.begun(act.Undo("d1"), "me")
        await asyncio.wait_for(pausing, 30)

    asyncio.run(play())


def test_it_is_looked_for_until_nobody_wants_it_any_more(repose, runtime, now, monkeypatch):
    async def soon(_seconds):
        now[0] = UNTOUCHED_S
        if runtime.rests:
            raise asyncio.CancelledError

    monkeypatch.setattr(repose, "pause", soon)
    with pytest.raises(asyncio.CancelledError):
        asyncio.run(repose.keep(lambda: VISITED))
