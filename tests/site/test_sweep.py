import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from kit.process.cli_process import ONIKA, CliProcess
from kit.process.process_tree import runtime_of

pytestmark = pytest.mark.site
SWEEP = ("sweep", "go_home", "--vary", "pd.STIFF=0.5..1", "--json")


def swept(folder: Path, *words: str) -> dict[int, dict[str, object]]:
    """The results by seed."""
    done = subprocess.run([*ONIKA, *SWEEP, *words], cwd=folder, capture_output=True, text=True, check=True)
    return {result["case"]["seed"]: result for result in map(json.loads, done.stdout.splitlines())}


def test_a_run_of_a_warm_runtime_is_the_same_as_one_by_itself_and_as_on_other_workers(tmp_path):  # R-X23, R-X08
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
    one, two = swept(tmp_path / "one", "--seeds", "4", "--jobs", "1"), swept(tmp_path / "two", "--seeds", "4")
    assert one == two
    last = one[3]
    value = last["case"]["values"]["pd.STIFF"]
    words = ("run", "go_home", "--virtual", "--seed", "3", "--shake", "3", "--vary", f"pd.STIFF={value!r}")
    alone = subprocess.run([*ONIKA, *words, "--json"], capture_output=True, text=True, check=True)
    assert json.loads(alone.stdout.splitlines()[-1])["hash"] == last["hash"]
    assert len({result["hash"] for result in one.values()}) == 4


def test_a_worker_that_is_killed_loses_no_run(tmp_path):  # R-X23
    before = swept(tmp_path, "--seeds", "6", "--out", "whole.sweep")
    path = tmp_path / "struck.sweep"
    words = [*ONIKA, *SWEEP, "--seeds", "6", "--jobs", "1", "--out", str(path)]
    with subprocess.Popen(words, cwd=tmp_path, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        first = process.stdout.readline()  # a run is done, the next one is under way
        os.kill(runtime_of(process.pid), signal.SIGKILL)
        rest = process.stdout.read()
    assert process.returncode == 0
    results = {line["case"]["seed"]: line for line in map(json.loads, (first + rest).splitlines())}
    assert results == before


def test_a_sweep_of_a_program_without_end_is_ended_by_one_control_c(tmp_path):  # R-X23, R-E10
    words = ("sweep", "wave_on", "--seeds", "2", "--jobs", "1", "--out", str(tmp_path / "it.sweep"))
    with CliProcess(*words) as program:
        until = time.monotonic() + 60.0
        while not any("onika.host.loading.loader" in words for words in program.processes().values()):
            assert time.monotonic() < until
        program.interrupt()
        assert program.code() == 130
        assert program.left_over() == []
