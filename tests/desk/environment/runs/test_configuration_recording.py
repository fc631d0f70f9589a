"""A configuration that lives is recorded from the page (requirement X05)."""

from dataclasses import replace

import msgspec
import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.runs import recording
from onika.model.task import Task
from onika.wire import act, event, live, request
from onika.words.reason import Reason

TASKS = (Task("a", "a", outvar=("A",), frequency=10.0),)


@pytest.fixture
def env(tmp_path):
    env = FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime())
    env.rebuffs = {live.Record: request.Done()}
    return env


def asked(env):
    return [message for message in env.carried_out if isinstance(message, live.Record)]


def test_a_configuration_that_lives_is_recorded_into_a_file_of_its_name(env, tmp_path):  # R-X05
    doc = env.connected("a")
    path = env.do(act.RecordByHand(doc))
    assert path.startswith(str(tmp_path / "state" / "recordings" / "Untitled-1-")) and path.endswith(".mcap")
    assert asked(env) == [live.Record("Untitled-1", path)]
    env.tell(event.Recording("Untitled-1", 1.0, path, is_on=True))
    assert env.environment.tree.documents[doc].recording == path
    again = env.no(act.RecordByHand(doc))
    assert again.remedies[0].act == act.RecordByHand(doc, is_on=False)
    env.do(act.RecordByHand(doc, is_on=False))
    assert asked(env)[-1] == live.Record("Untitled-1")
    env.tell(event.Recording("Untitled-1", 3.0, path, is_on=False, lasted_s=2.0))
    assert env.environment.tree.documents[doc].recording == ""


def test_what_is_not_connected_or_does_not_live_is_not_recorded(env):  # R-X05
    doc = env.new("a")
    assert env.no(act.RecordByHand(doc)).remedies[0].act == act.Connect(doc)
    bare = env.connected()
    assert "nothing lives" in str(env.no(act.RecordByHand(bare)).reason)
    assert asked(env) == []


def test_a_runtime_of_somebody_else_records_nothing(env):  # R-X05
    doc = env.connected("a")
    elsewhere = msgspec.structs.replace(env.environment.model.runtime, address="wss://cell:7777")
    env.environment.become(lambda model: Done(replace(model, runtime=elsewhere)))
    assert "wss://cell:7777" in str(env.no(act.RecordByHand(doc)).reason)
    assert asked(env) == []


def test_where_the_disk_is_full_it_is_told_before(env, monkeypatch):  # R-X05
    doc = env.connected("a")
    monkeypatch.setattr(recording, "LEAST_BYTES", 1 << 62)
    assert "MB" in str(env.no(act.RecordByHand(doc)).reason)
    assert asked(env) == []


def test_the_runtimes_refusal_is_told(env):  # R-X05
    doc = env.connected("a")
    env.rebuffs = {live.Record: request.Refused(Reason.of("host.too_many_recordings", most=4))}
    assert "at most 4 recordings" in str(env.no(act.RecordByHand(doc)).reason)
