from time import monotonic_ns

import pytest

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.desk.run.recorded_run import inputs_of
from onika.host.units.realtime_factor import FASTEST, SLOWEST, RealtimeFactor
from onika.record import topics
from onika.record.reader import Reader
from onika.record.run import RunRecord
from onika.record.series import Series
from onika.wire import event, live, request, steer

PLAN = rail_tasks().plan([action("mass", "servo", arguments=goal) for goal in ("1.0", "2.0")])


@pytest.fixture
def path(tmp_path):
    return tmp_path / "run.mcap"


def begun(path, **how):
    desk = DirectClient()
    desk.ask(request.Prepare(PLAN, ()))
    assert desk.ask(request.Begin(record=str(path), **how)) == request.Done()
    return desk


def test_a_run_is_recorded_with_all_that_law_29_asks_for(path):  # R-X05, law 29
    desk = begun(path, seed=5)
    result = desk.to_the_end()
    reader = Reader(path)
    run = RunRecord.read(reader)
    assert (run.prepare.plan, run.begin.seed, run.is_virtual, run.is_fresh) == (PLAN, 5, True, True)
    assert reader.notes["end"]["hash"] == result.hash
    assert Series.all_of(reader)["flow0/X"].at(10**12) == pytest.approx(result.values.get("X", [2.0, 0.0]), abs=0.05)
    events = [topics.decode_happened(body).event for _, body in reader.messages(topics.EVENTS)]
    expected = [message for message in desk.server.events if not isinstance(message, event.Company | event.Result)]
    assert [message for message in events if not isinstance(message, event.Result)] == expected
    assert isinstance(events[-1], event.Result)
    assert reader.count(topics.frames("yard")) > 10


def test_a_recording_changes_nothing_in_the_run(path):  # R-X05
    desk = DirectClient()
    desk.ask(request.Prepare(PLAN, ()))
    desk.ask(request.Begin())
    assert desk.to_the_end().hash == begun(path).to_the_end().hash


def test_what_is_asked_is_recorded_and_what_only_looks_is_not(path):  # law 29
    desk = begun(path)
    desk.ask(live.Survey())
    desk.ask(steer.Pause())
    desk.to_the_end()
    desk.ask(steer.Resume())
    desk.to_the_end()
    inputs = inputs_of(Reader(path))
    assert [type(request.decode_request(recorded.body)) for recorded in inputs] == [steer.Pause, steer.Resume]
    assert inputs[0].at_ns <= inputs[1].at_ns


def test_one_run_is_recorded_at_a_time_and_a_later_one_knows_that_it_is_not_the_first(path, tmp_path):  # law 29
    desk = begun(path)
    desk.ask(request.Prepare(PLAN, ()), "other")
    refused = desk.ask(request.Begin(record=str(tmp_path / "b.mcap")), "other")
    assert isinstance(refused, request.Refused)
    desk.to_the_end()
    desk.ask(request.Prepare(PLAN, ()))
    assert desk.ask(request.Begin(record=str(tmp_path / "c.mcap"))) == request.Done()
    desk.to_the_end()
    assert not RunRecord.read(Reader(tmp_path / "c.mcap")).is_fresh


def test_a_file_that_cannot_be_made_refuses_the_run(tmp_path):  # R-E01
    desk = DirectClient()
    desk.ask(request.Prepare(PLAN, ()))
    answer = desk.ask(request.Begin(record=str(tmp_path / "none" / "run.mcap")))
    assert str(answer.reason).startswith("no recording can be made")
    assert desk.ask(request.Begin()) == request.Done()


def test_a_recorded_run_is_repeated_bit_for_bit(path):  # R-X05
    desk = begun(path)
    while desk.driver.now < 300_000_000:
        desk.program.advance(0)
    desk.ask(steer.Skip("flow0", 1))
    result = desk.to_the_end()
    again = DirectClient()
    again.ask(request.Prepare(PLAN, ()))
    again.ask(request.Begin(repeat=tuple(inputs_of(Reader(path))), repeat_until_ns=-1))
    assert again.to_the_end().hash == result.hash


def test_a_subsystem_that_is_only_held_does_not_keep_a_run_from_being_the_first(path):  # law 29
    desk = DirectClient()
    assert desk.ask(live.Take("main")) == request.Done()
    desk.ask(request.Prepare(PLAN, ()))
    assert desk.ask(request.Begin(record=str(path))) == request.Done()
    desk.to_the_end()
    assert RunRecord.read(Reader(path)).is_fresh


def test_what_is_repeated_goes_as_fast_as_it_can_and_the_rest_as_the_wall_lets_it(path):  # R-X05, A16
    desk = begun(path)
    result = desk.to_the_end()
    until = round(result.runtime_s * 1e9) - 300_000_000
    again = DirectClient()
    again.driver._realtime_factor = RealtimeFactor(SLOWEST, 0, monotonic_ns())
    again.ask(request.Prepare(PLAN, ()))
    again.ask(request.Begin(repeat=tuple(inputs_of(Reader(path), until)), repeat_until_ns=until))
    began = monotonic_ns()
    while again.driver.now < until:  # which would take the wall a hundred times as long
        again.program.advance(1_000_000)
    for _ in range(5):
        again.program.advance(1_000_000)
    passed = monotonic_ns() - began
    assert again.driver.now - until <= passed * SLOWEST + 1
    again.driver._realtime_factor = RealtimeFactor(FASTEST, again.driver.now, monotonic_ns())
    while not again.of(event.Result):
        again.program.advance(1_000_000)
    assert again.of(event.Result)[0].hash == result.hash


def test_a_disk_that_is_full_ends_the_recording_and_not_the_run(path):  # R-X05
    desk = begun(path)
    desk.program.recordings.recorder._writer.reason = "No space left on device"
    desk.program.advance(1_000_000)
    assert desk.of(event.Warned)  # told at once, and once
    result = desk.to_the_end()
    assert result.completed
    warned = [str(message.text) for message in desk.of(event.Warned)]
    assert warned == ["the recording is not whole: No space left on device"]
