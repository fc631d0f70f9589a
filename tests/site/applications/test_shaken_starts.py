"""Every shipped application comes to its end though its workcell does not stand quite as it should at the start."""

import subprocess
from pathlib import Path

import pytest

import onika
from kit.process.cli_process import ONIKA

pytestmark = [pytest.mark.site, pytest.mark.slow]

SEEDS = 3
LEFT_OUT = {
    "find_twins": "asks for a folder",
    "gather_pictures": "asks for a folder",
    "teach_by_pad": "waits for somebody at the pad",
    "wave_on": "has no end",
    "visit": "has a hole, for whoever visits something",
    "workshop_drift": "shows how a fault ends a run",
    "workshop_lost": "shows how a fault ends a run",
    "workshop_stuck": "shows how a fault ends a run",
}
APPLICATIONS = sorted(Path(onika.__file__).parent.glob("labs/*/appl/*.appl"))


@pytest.mark.parametrize(
    "path", [path for path in APPLICATIONS if path.stem not in LEFT_OUT], ids=lambda path: path.stem
)
def test_it_is_completed_from_shaken_starts(tmp_path, path):  # R-X23, R-K06
    words = ["sweep", str(path), "--seeds", str(SEEDS), "--jobs", "2", "--out", str(tmp_path / "it.sweep")]
    done = subprocess.run([*ONIKA, *words], capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{SEEDS} runs, {SEEDS} good" in done.stdout


def test_those_left_out_are_there():
    assert set(LEFT_OUT) <= {path.stem for path in APPLICATIONS}
