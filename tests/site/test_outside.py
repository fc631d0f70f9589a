"""The example programs of `docs/examples` as outside partners of tasks, in real runs: Python, C and JavaScript."""

import json
import shutil
import socket
import subprocess
import sys
import urllib.request
from pathlib import Path

import numpy as np
import pytest

from kit.labs.laboratory import Laboratory, job, joints
from onika.cli import main
from onika.laws import puma560
from onika.store.shipped import shipped

pytestmark = pytest.mark.site

EXAMPLES = Path(__file__).parents[2] / "docs" / "examples"
HOME = np.array(puma560.HOME)
ASIDE = HOME + np.array([0.5, 0.1, 0.0, 0.0, 0.2, 0.0])
VIRTUAL, WALL = ["--virtual"], []


class Place:
    """A laboratory with a job of the arm without forces and one task that has a partner."""

    def __init__(self, path, capsys):
        self.lab = Laboratory(path)
        self._capsys = capsys

    def partner(self, name, **local):
        """The shipped task of this name, with another partner."""
        code = next(shipped().glob(f"*/module/{name}.py"))
        self.lab.module(f"my_{name}", code.read_text())
        text = code.with_suffix(".rmod").read_text().partition("LOCAL")[0]
        rows = "".join(f"{key}  {words}\n" for key, words in {"PATIENCE": 20, **local}.items())
        self.lab.task(f"my_{name}", text.replace(f" {name}\n", f" my_{name}\n", 1) + "LOCAL\n" + rows)
        return self

    def run(self, *tasks, mode=VIRTUAL, expect=0, seconds=0.5):
        """Run one move with these tasks; all that was told, the result last."""
        self.lab.configuration("moveC", "puma_kin 500", *tasks)
        move = [job("moveC", "Joint job"), joints("there", *ASIDE, duration=seconds)]
        code = main(["run", str(self.lab.application("move", move)), *mode, "--json"])
        events = [json.loads(line) for line in self._capsys.readouterr().out.splitlines()]
        assert code == expect, events
        return events


@pytest.fixture
def place(tmp_path, capsys):
    return Place(tmp_path / "lab", capsys)


def words(events):
    return json.dumps(events)


def test_the_display_in_python_is_started_by_its_task_and_ends_with_it(place, tmp_path):  # R-F04
    shown = tmp_path / "shown"
    script = f"sh -c 'exec {sys.executable} {EXAMPLES / 'display.py'} --plain 2> {shown}'"
    events = place.partner("display", STARTS=script).run("my_display 20", "jtraj 250")
    rows = [line.split(" ", 2) for line in shown.read_text().splitlines()]
    assert len(rows) >= 5
    assert np.array(json.loads(rows[-1][2])["Q_MEZ"]) == pytest.approx(ASIDE, abs=0.05)
    assert events[-1]["outside"] == ["flow0/my_display"]
    assert events[-1]["missed"]["flow0/my_display"] == 0


@pytest.mark.skipif(not shutil.which("cc"), reason="there is no C compiler here")
def test_the_logger_in_c_writes_every_row(place, tmp_path):  # R-F04
    program, log = tmp_path / "logger", tmp_path / "run.csv"
    subprocess.run(["cc", "-Wall", "-Wextra", "-Werror", "-O1", "-o", program, EXAMPLES / "logger.c"], check=True)
    place.partner("logger", STARTS=f"{program} {log}").run("my_logger 50", "jtraj 250")
    rows = np.loadtxt(log, delimiter=",")
    assert rows.shape[1] == 13
    assert np.diff(rows[:, 0]) == pytest.approx(0.02)
    assert rows[0, 0] == 0.0
    assert rows[-1, 7:] == pytest.approx(ASIDE)


def test_the_planner_in_python_leads_the_arm_round_a_ball(place, tmp_path):  # R-F04, Figure 23
    middle = (HOME + ASIDE) / 2
    ball = ",".join(map(str, middle)) + ":0.1"
    script = f"{sys.executable} {EXAMPLES / 'planner.py'} --ball {ball}"
    log = tmp_path / "log"
    recorder = f"{sys.executable} {_recorder(tmp_path)} {log}"
    place.partner("planner", STARTS=script).partner("logger", STARTS=recorder)
    place.run("my_logger 100", "my_planner 250", mode=WALL, seconds=1.0)
    rows = np.array([json.loads(line)["row"] for line in log.read_text().splitlines()])
    references = rows[5:, 6:]
    assert references[-1] == pytest.approx(ASIDE, abs=1e-3)
    assert np.linalg.norm(references - middle, axis=1).min() > 0.099


def _recorder(folder):
    """A logger of three lines: how little a partner has to be."""
    path = folder / "recorder.py"
    path.write_text(
        "import json, sys\nout = open(sys.argv[1], 'w', buffering=1)\nfor rows, line in enumerate(sys.stdin, 1):\n"
        "    out.write(line)\n    print(json.dumps({'id': json.loads(line)['id'], 'rows': rows}), flush=True)\n"
    )
    return path


@pytest.mark.skipif(not shutil.which("node"), reason="there is no Node here")
def test_the_view_in_javascript_shows_arm_and_numbers_of_two_tasks(place):  # R-F04: two tasks, one partner
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        door = f"tcp:127.0.0.1:{probe.getsockname()[1]}"
    command = ["node", EXAMPLES / "view.mjs", "--page", "0", door]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as view:
        try:
            url = view.stderr.readline().strip()
            place.partner("view3d", PARTNER=door).partner("display", PARTNER=door)
            place.run("my_view3d 25", "my_display 20", "jtraj 250")
            with urllib.request.urlopen(url + "state", timeout=10) as answer:
                state = json.load(answer)
            with urllib.request.urlopen(url, timeout=10) as answer:
                assert "<canvas" in answer.read().decode()
        finally:
            view.kill()
    assert np.shape(state["flow0/my_view3d"]["points"]) == (8, 3)
    assert state["flow0/my_display"]["values"]["Q_MEZ"] == pytest.approx(list(ASIDE), abs=0.02)


def test_without_its_partner_a_passive_task_goes_off_and_the_job_goes_on(place, tmp_path):  # R-F04
    nobody = f"unix:{tmp_path / 'nobody'}"
    events = place.partner("display", PARTNER=nobody, PATIENCE=0.1).run("my_display 20", "jtraj 250", mode=WALL)
    assert events[-1]["state"] == "completed"
    assert "nobody listens (No such file or directory): it goes off" in words(events)
    assert "my_display has switched itself off" in words(events)


@pytest.mark.parametrize(
    ("mode", "script", "cause"),
    [
        (WALL, "input(); raise SystemExit(4)", "its program ended with exit code 4"),
        (VIRTUAL, "input()\nwhile True: print('{\"id\": 7}')", "expected an answer"),
    ],
    ids=["dies in the middle", "floods"],
)
def test_a_planner_that_fails_ends_the_run_with_the_cause_and_moves_nothing(place, tmp_path, mode, script, cause):
    bad = tmp_path / "bad.py"  # R-F04
    bad.write_text(script)
    log = tmp_path / "log"
    recorder = f"{sys.executable} {_recorder(tmp_path)} {log}"
    place.partner("planner", STARTS=f"{sys.executable} {bad}").partner("logger", STARTS=recorder)
    events = place.run("my_logger 100", "my_planner 250", mode=mode, expect=1)
    assert cause in events[-1]["cause"]["text"]
    rows = [json.loads(line)["row"] for line in log.read_text().splitlines()]
    assert all(row[:6] == pytest.approx(rows[0][:6], abs=1e-9) for row in rows)
    assert rows or mode  # in virtual time the planner's answer may come before the first row
