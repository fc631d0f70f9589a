"""Every kind of process is killed and frozen, also while it starts: nothing stays behind, and every recording reads.

The limits in s are those of a machine that has time (`make soak`); here they are stretched.
"""

import os
import signal

import pytest

from kit.faults.blows import FREEZES, KINDS, LEFT_S, Blow, Kind, Stage, blows, strike
from kit.process.cli_process import CliProcess
from kit.process.traces import Traces
from onika.record.reader import Reader

pytestmark = pytest.mark.site

PATIENCE = 6.0
KILLS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
CASES = (
    (Stage.RECORDED, Blow(Kind.COMMAND, signal.SIGKILL, 3.0)),
    (Stage.RECORDED, Blow(Kind.UNIT, signal.SIGSTOP, 0.0)),
    (Stage.RECORDED, Blow(Kind.RECORDING, signal.SIGSTOP, 0.5)),
    (Stage.PAGE, Blow(Kind.RUNTIME, signal.SIGSTOP, 0.2)),
)


@pytest.mark.parametrize(("stage", "blow"), CASES, ids=[f"{stage} {blow}" for stage, blow in CASES])
def test_nothing_stays_behind_after_a_blow(tmp_path, stage, blow):  # R-E10, R-F01, R-X05
    aftermath = strike(stage, blow, tmp_path)
    assert aftermath.has_hit
    assert aftermath.faults(PATIENCE) == [], aftermath.output[-5:]


def test_a_power_cut_of_all_processes_at_once_leaves_nothing_behind(tmp_path):  # R-E10, R-F01, R-X05
    traces, recording = Traces(tmp_path), tmp_path / "run.mcap"
    words = ("run", "go_home", "--json", "--record", str(recording))
    with CliProcess(*words, environment=traces.environment) as console:
        console.until(event="drive", state="DRIVEN")
        processes = traces.processes()
        for signum in (signal.SIGSTOP, signal.SIGKILL):  # nobody sees another one die
            for pid in processes:
                os.kill(pid, signum)
        assert console.code() == -signal.SIGKILL
    assert any(Kind.RECORDING in command for command in processes.values())
    assert traces.left_over(LEFT_S * PATIENCE) == []
    assert not list(traces.home.rglob("*.unfinished"))
    Reader(recording).close()


@pytest.mark.slow
@pytest.mark.parametrize("is_freeze", [False, True], ids=["kills", "freezes"])
@pytest.mark.parametrize(("stage", "kind"), [(stage, kind) for stage in Stage for kind in KINDS[stage]])
def test_nothing_stays_behind_after_many_blows(tmp_path, stage, kind, is_freeze):  # R-E10, R-F01, R-X05
    is_usual = stage is Stage.RECORDED or kind is Kind.LISTENER
    signals = FREEZES if is_freeze else KILLS
    faults = {}
    for number, blow in enumerate(blows(stage, kind, 30 if is_usual else 4, signals, seed=0)):
        aftermath = strike(stage, blow, tmp_path / str(number))
        if aftermath.faults():
            faults[str(blow)] = aftermath.faults(), aftermath.output[-3:]
    assert faults == {}
