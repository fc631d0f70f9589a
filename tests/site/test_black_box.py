"""The last seconds of a run that ends badly, in real processes (requirement X05)."""

import os
import signal
import stat
from pathlib import Path

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.process.cli_process import CliProcess
from onika.desk.run.run_review import Review
from onika.record.black_box_folder import black_box_folder, black_boxes

pytestmark = pytest.mark.site

ARM = ("puma 500", "diff 500", "gravcomp 250", "pd 500", "torque_sum 500", "led_monitor 50")


def program(tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.configuration("moveC", *ARM, "jtraj 250")
    move = job("moveC", "Joint job")
    near = joints("near", 0.05, -1.57, 1.57, 0.0, 0.0, 0.0, duration=1.0)
    there = joints("there", 1.0, -1.57, 1.57, 0.0, 0.0, 0.0, duration=20.0)
    return str(laboratory.application("move", [move, near, move, there]))


@pytest.fixture
def state(tmp_path):
    return {"XDG_STATE_HOME": str(tmp_path / "state")}


def boxes(state):
    return black_boxes(black_box_folder(state))


def assert_last_seconds(path):
    """An ordinary recording that reads to its end, whose last values are those of the moment."""
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    with Review(path) as review:
        assert review.is_whole
        assert review.ending["completed"] == "no"
        position = review.series["flow0/Q_MEZ"]
        times = [at for at, _ in position.values()]
        assert len(set(times)) > 10
        assert review.span_s[1] - times[-1] * 1e-9 < 0.5
        return review.ending["cause"]


def test_a_killed_processing_unit_leaves_a_black_box_that_the_result_names(tmp_path, state):  # R-X05, law 17
    with CliProcess("run", program(tmp_path), "--json", environment=state) as console:
        console.until(event="began", index=1)
        os.kill(console.process("onika.host.units.rtpu"), signal.SIGKILL)
        result = console.result()
        assert console.code() == 1
        assert console.left_over() == []
    assert [str(path) for path in boxes(state)] == [result["black_box"]]
    assert "signal 9" in assert_last_seconds(Path(result["black_box"]))


def test_a_killed_runtime_leaves_a_black_box_that_the_result_names(tmp_path, state):  # R-X05
    with CliProcess("run", program(tmp_path), "--json", environment=state) as console:
        console.until(event="began", index=1)
        os.kill(console.process("onika.host --link-fd"), signal.SIGKILL)
        result = console.result()
        assert console.code() == 1
        assert console.left_over() == []
    assert [str(path) for path in boxes(state)] == [result["black_box"]]
    assert assert_last_seconds(Path(result["black_box"])) == "the runtime program has died"
