"""A library written elsewhere, in its own names, runs with ours: SVARALIAS joins them (R-C04, dissertation §A.1)."""

import json
import shutil
from pathlib import Path

import pytest

from onika.cli import main

pytestmark = pytest.mark.site

OTHER = Path(__file__).parents[2] / "data" / "other_site"
GOAL = ["Q_MEZ[0] < 0.01", "Q_MEZ[0] > -0.01", "Q_MEZ[4] > 0.775", "Q_MEZ[4] < 0.796"]


def run(capsys, base):
    expected = [word for text in GOAL for word in ("--expect", text)]
    code = main(["run", str(base / "appl" / "there_and_back.appl"), "--virtual", "--json", *expected])
    return code, json.loads(capsys.readouterr().out.splitlines()[-1])


def test_the_tasks_of_another_site_are_without_fault(capsys):  # R-B01
    assert main(["check", str(OTHER)]) == 0
    assert capsys.readouterr().out.splitlines()[-1].endswith("no faults")


def test_tasks_in_other_names_drive_our_robot(capsys):  # R-B01, R-C04, reading 8
    code, result = run(capsys, OTHER)
    assert (code, result["state"], result["actions_done"]) == (0, "completed", 2)


@pytest.mark.parametrize("alias", ["SVARALIAS   HIGHEST=QMAX\n", "SVARALIAS   N_AX    = NDOF\n"])
def test_without_one_of_its_aliases_it_is_refused(capsys, tmp_path, alias):  # R-C04, law 10
    shutil.copytree(OTHER, tmp_path, dirs_exist_ok=True)
    path = tmp_path / "module" / "ramp.rmod"
    text = path.read_text()
    assert alias in text
    path.write_text(text.replace(alias, ""))
    code, result = run(capsys, tmp_path)
    assert (code, result["state"]) == (2, "refused")
    assert any("constant" in fault["reason"]["text"] for fault in result["faults"])
