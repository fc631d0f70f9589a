"""Motions by so much from where the hand is, with both arms, in virtual time: they run, are checked and foretold."""

import json

import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
from onika.cli import main
from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.store.site import open_site

ABOVE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)
PLACES = {"": (0.7, 0.28, -0.125), "_right": (0.55, -0.28, -0.125)}
"""Where these joints bring the hand of either arm."""


def lifted(path, arm, by, times):
    """A program that goes to a place, and on by so much."""
    place = [job(f"jmove{arm}C", "Joint job"), joints("above", *ABOVE, duration=3.0)]
    on = [job(f"cshift{arm}C", "Relative job"), target("by", "Relative object", by, "1.0")]
    return Laboratory(path).application("lift", [*place, *on * times])


@pytest.mark.site
@pytest.mark.parametrize("arm", ["", "_right"])
def test_the_hand_goes_on_from_where_it_is_with_either_arm(capsys, tmp_path, arm):  # R-D25
    path = lifted(tmp_path, arm, "-0.02 0.01 0.1", 2)
    code = main(["run", str(path), "--virtual", "--json", "--expect", "X_MEZ[2,3] > 0"])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert (code, result["actions_done"]) == (0, 3)
    hand = [row[3] for row in result["values"]["X_MEZ"][:3]]
    assert hand == pytest.approx(
        [at + 2 * step for at, step in zip(PLACES[arm], (-0.02, 0.01, 0.1), strict=True)], abs=2e-3
    )


def test_what_lies_out_of_reach_from_there_is_told_before_anything_moves(tmp_path):  # R-D25, law 26
    for by, is_wrong in (("0.0 0.0 0.1", False), ("0.0 0.0 1.2", True)):
        planned = prepare_run(str(lifted(tmp_path, "", by, 1)), open_site([], {}, None))
        faults = prepare(planned.plan, planned.targets, ModuleFacts()).faults
        assert [fault.reason.key for fault in faults] == ["host.unreachable"] * is_wrong
