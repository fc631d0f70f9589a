"""A modular arm: its number of joints changes while the runtime, and its job, live (requirements K04, A03)."""

import json
import re

import pytest

from kit.process.cli_process import CliProcess
from onika.cli import main

pytestmark = pytest.mark.site

GROWS = """
config jmove_modular3C @out_3
wait jtraj off
config jmove_modular5C @out_5
read NDOF Q_MEZ
wait jtraj off
read NDOF Q_MEZ
config jmove_modular4C @out_4
read NDOF Q_MEZ
wait jtraj off
get jtraj progress
status
kill all
quit
"""

ASKS = """
config jmove_modular3C @out_3
advance 1
config jmove_modular5C
read NDOF Q_MEZ
answer jtraj @out_5
wait jtraj off
read NDOF Q_MEZ
kill all
quit
"""


def said(tmp_path, text):
    """What a script reads: numbers of joints and where they are, in turn; and all that was said."""
    path = tmp_path / "script"
    path.write_text(text)
    with CliProcess("runtime", "--no-fifo", "--script", str(path), "--virtual", "--no-console") as console:
        output = console.text()
        assert console.code() == 0, output
    counts = [int(count) for count in re.findall(r"^NDOF = (\d+)", output, re.MULTILINE)]
    rows = [[float(word) for word in row.split()] for row in re.findall(r"^Q_MEZ = (.*)$", output, re.MULTILINE)]
    return counts, rows, output


def test_modules_are_attached_and_taken_off_and_the_joint_job_lives_on(tmp_path):  # R-K04, R-A03, law 22
    counts, rows, output = said(tmp_path, GROWS)
    assert counts == [5, 5, 4]
    assert rows[0] == pytest.approx([0.8, 0.6, 0.7, 0.0, 0.0], abs=2e-3)
    assert rows[1] == pytest.approx([0.8, 0.6, 0.7, -0.9, 0.8], abs=2e-3)
    assert rows[2] == pytest.approx([0.8, 0.6, 0.7, -0.9], abs=2e-3)
    assert re.search(r"^jtraj +jtraj +rt0 +OFF +15\d\d ", output, re.MULTILINE), "one task, three motions"


def test_a_job_that_is_on_asks_for_a_target_of_the_new_shape(tmp_path):  # R-A03, law 12
    counts, rows, output = said(tmp_path, ASKS)
    assert counts == [5, 5]
    assert rows[0] == pytest.approx([0.4, 0.3, 0.35, 0.0, 0.0], abs=5e-3)
    assert rows[1] == pytest.approx([0.8, 0.6, 0.7, -0.9, 0.8], abs=2e-3)
    assert "expected 6 values (endpoint[5], duration[1]), found 4" in output


def test_the_longest_arm_runs_an_application(capsys):  # R-K04
    code = main(["run", "modular_out", "--virtual", "--json", "--expect", "Q_MEZ[4] > 0.79"])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert (code, result["state"], result["notes"]) == (0, "completed", [])
