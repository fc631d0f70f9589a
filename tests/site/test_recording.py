"""Real runs that are recorded, cut short, and begun again from their recordings (requirement X05, law 29)."""

import json
import os
import signal
import subprocess
from time import monotonic, sleep

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.labs.laboratory import Laboratory, job
from kit.process.cli_process import ONIKA
from onika.cli import main
from onika.desk.environment.initial_model import opened
from onika.desk.run.recorded_run import inputs_of
from onika.desk.run.run import start
from onika.desk.run.run_review import Review
from onika.desk.run.settings import RecordingSource, RunSettings
from onika.record.difference import first_difference
from onika.record.reader import Reader
from onika.record.tolerance import Tolerance
from onika.store.site import open_site
from onika.wire import act, event, request, steer

pytestmark = pytest.mark.site

TRIES = 5

SITE = open_site([], {}, None)
GAUGE = """
from onika.module import Input, Module, OutVar, finish


class Gauge(Module):
    trigger = True

    LEVEL = OutVar("double[2]", "m", "what was said")

    level = Input("double[2]", "m", "how high on both sides", low=0.0, high=1.0)

    def on(self, inputs):
        self.LEVEL = [inputs.level[0], self.random.random()]
        self.left = 10

    def cycle(self):
        self.left -= 1
        return None if self.left else finish()
"""


def steered(running):
    """Pause, skip and mark a run; when it is paused for the last time, and how it ends."""
    for message in running.events():
        if isinstance(message, event.Began) and message.index == 1:
            assert running.steer("pause") == ()
        if isinstance(message, event.Moved) and message.state == "paused":
            break
    assert running.wait("0.5") == ()
    assert running.steer("skip 22") == ()
    assert running.steer("break 23") == ()
    assert running.wait("paused") == ()
    assert running.wait("0.123456789") == ()
    paused_s = running.now_s
    assert running.steer("skip 25") == ()
    return paused_s, running.result()


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """A steered virtual run: its recording, when it was paused last, its result."""
    path = tmp_path_factory.mktemp("recorded") / "run.mcap"
    with start(RunSettings("assemble", is_virtual=True, seed=7, record=path), SITE) as running:
        paused_s, result = steered(running)
    assert result.completed
    return path, paused_s, result


def test_a_recorded_run_is_the_same_as_one_that_is_not(recorded):  # R-X05, law 29
    with start(RunSettings("assemble", is_virtual=True, seed=7), SITE) as running:
        _, result = steered(running)
    assert result.hash == recorded[2].hash


def test_what_was_asked_stands_in_the_recording(recorded):  # law 29
    reader = Reader(recorded[0])
    requests = [request.decode_request(recorded.body) for recorded in inputs_of(reader)]
    skips = [command.action for command in requests if isinstance(command, steer.Skip)]
    assert isinstance(requests[0], steer.Pause)
    assert skips == [21, 24]
    assert reader.notes["end"]["hash"] == recorded[2].hash
    assert (reader.is_whole, reader.notes["end"]["missed"], reader.notes["onika"]["seed"]) == (True, "0", "7")


def test_a_run_repeated_to_its_end_is_the_same_bit_for_bit(recorded, tmp_path, capsys):  # R-X05
    again = tmp_path / "again.mcap"
    code = main(["run", "--from", str(recorded[0]), "--json", "--record", str(again)])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert (code, result["hash"]) == (0, recorded[2].hash)
    assert first_difference(Reader(recorded[0]), Reader(again), Tolerance()) is None
    assert main(["recording", "diff", str(recorded[0]), str(again)]) == 0


def test_continued_from_an_instant_with_the_same_inputs_it_is_the_same_run(recorded):  # R-X05
    path, paused_s, result = recorded
    for at_s in (paused_s - 0.05, paused_s - 0.0123):  # it is paused there; one of them is no time of any task
        with start(RunSettings("", is_virtual=True, source=RecordingSource(path, at_s)), SITE) as running:
            assert running.wait(f"{paused_s - at_s:.9f}") == ()
            assert running.now_s == pytest.approx(paused_s, abs=1e-9)
            assert running.steer("skip 25") == ()
            assert running.result().hash == result.hash


def test_continued_from_an_instant_with_other_inputs_it_is_another_run(recorded, tmp_path):  # R-X05
    path, paused_s, result = recorded
    other = tmp_path / "other.mcap"
    settings = RunSettings("", is_virtual=True, source=RecordingSource(path, paused_s - 0.1), record=other)
    with start(settings, SITE) as running:
        assert running.wait("paused") == ()
        assert running.steer("skip 24") == ()
        changed = running.result()
    assert changed.hash != result.hash
    difference = first_difference(Reader(path), Reader(other), Tolerance())
    assert difference is not None
    assert difference.at_ns * 1e-9 == pytest.approx(paused_s, abs=0.2)


def test_any_instant_is_there_at_once(recorded):  # R-X05: scrubbing within 100 ms
    with Review(recorded[0]) as review:
        began = monotonic()
        instant = review.at(review.span_s[1] / 2)
        assert monotonic() - began < 0.1
        assert instant.tasks["flow0/puma"] == "ON"
        assert len(instant.variables["flow0/Q_MEZ"]) == 6
        assert len(instant.poses["boxes"]) > 10
        assert [interval.action for interval in review.flows[0].intervals] == [0, 1, 21, 22, 24]


def test_a_page_shows_a_real_run_at_its_icons(recorded, tmp_path):  # R-X05: canvas, flows, 3-D show that instant
    model, _ = opened(SITE, None, {})
    sitting = EnvironmentFixture(tmp_path, model=model, site=SITE)
    assert sitting.later(act.OpenRecording(str(recorded[0]))).no is None
    view = sitting.environment.tree.review.recording
    icons = sitting.environment.tree.applications[view.doc].steps
    assert [passage.action for passage in view.flows["flow0"].passages] == [0, 1, 21, 22, 24]
    assert {icons[str(passage.step)].name for passage in view.flows["flow0"].passages} == {
        "opengripC",
        "jmoveC",
        "cmoveC",
    }
    commands = [mark.text for mark in view.marks if mark.kind == "command"]
    assert str(commands[0]) == "pause: flow0" and commands[1].key == "run.skip_to"
    late = view.flows["flow0"].passages[1].begin_s + 0.5
    instant = sitting.do(act.Glance(late))
    assert instant.run.steps[str(view.flows["flow0"].passages[1].step)].state == "running"
    shapes = sitting.do(act.RecordedScene("boxes"))["shapes"]
    assert any(shape["paint"] == "glow" for shape in shapes)
    assert len(instant.poses["boxes"]["rows"]) > max(shape["body"] for shape in shapes)


def test_an_answer_is_given_again_by_itself(tmp_path, capsys):  # R-X05, law 25
    laboratory = Laboratory(tmp_path)
    laboratory.module("gauge", GAUGE)
    laboratory.plain_task("gauge", writes="LEVEL")
    laboratory.configuration("gaugeC", "gauge 50")
    path = laboratory.application("measure", [job("gaugeC"), job("gaugeC")])
    run = tmp_path / "run.mcap"
    settings = RunSettings(str(path), is_virtual=True, seed=3, record=run, may_ask=True)
    with start(settings, open_site([], {}, tmp_path)) as running:
        for message in running.events():
            if isinstance(message, event.Asked):
                running.answer(message, f"0.{message.at_s * 1000:.0f}1 0.5")
        original = running.result()
    assert original.completed, original.cause
    assert main(["run", "--from", str(run), "--json"]) == 0
    assert json.loads(capsys.readouterr().out.splitlines()[-1])["hash"] == original.hash


def killed_in_its_midst(path, options):
    """When the last action began that was told before the kill; 0 where the machine was late and it ended by itself."""
    words = [*ONIKA, "run", "assemble", *options, "--record", str(path), "--json"]
    pid, seen_s = 0, 0.0
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as program:
        for line in program.stdout:
            answer = json.loads(line)
            pid = answer.get("runtime_pid", pid) or pid
            if answer["event"] == "began" and answer["at_s"] > 1.5:
                seen_s = answer["at_s"]
                os.kill(pid, signal.SIGKILL)
                break
        program.communicate()
    return seen_s


@pytest.mark.parametrize("options", [pytest.param(("--virtual", "--scale", "4"), marks=pytest.mark.slow), ()])
def test_what_was_recorded_before_a_kill_is_there(tmp_path, options):  # R-X05, K03
    path = tmp_path / "run.mcap"
    seen_s = next(filter(None, (killed_in_its_midst(path, options) for _ in range(TRIES))))
    until = monotonic() + 5.0
    while monotonic() < until and Reader(path).span[1] * 1e-9 < seen_s - 2.0:
        sleep(0.01)  # in wall time another process writes what it has seen yet
    with Review(path) as review:
        assert not review.is_whole
        assert review.span_s[1] > seen_s - 2.0
        assert review.at(1.0).tasks["flow0/puma"] == "ON"
        assert review.flows[0].intervals[0].begin_s < seen_s
    with start(RunSettings("", is_virtual=True, source=RecordingSource(path, 1.0)), SITE) as running:  # law 29
        assert running.wait("0.25") == ()
        assert running.now_s == 1.25
        notes = running.outcome.notes
    assert any(note.key == "desk.repeat_approximate" for note in notes) == ("--virtual" not in options)


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["go_home", "--record", "/proc/none/run.mcap"], "expected a file in a directory"),
        (["--from", "nothing.mcap"], "nothing.mcap"),
        (["go_home", "--runtime", "ws://127.0.0.1:1", "--record", "run.mcap"], "a runtime that is launched here"),
        (["go_home", "--at", "3"], "--from"),
    ],
)
def test_what_cannot_be_recorded_or_repeated_is_refused(words, expected, tmp_path, monkeypatch, capfd):  # R-E01
    monkeypatch.chdir(tmp_path)
    try:
        code = main(["run", *words])
    except SystemExit as end:
        code = end.code
    captured = capfd.readouterr()
    assert code == 2
    assert expected in captured.out + captured.err
