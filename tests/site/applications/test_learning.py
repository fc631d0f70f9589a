"""An arm whose weight is borne by a neural network (K09)."""

import pytest

from onika.cli import main

pytestmark = pytest.mark.site


def test_an_arm_goes_home_on_what_a_network_has_learnt(capsys):  # R-K09
    near_home = ["Q_MEZ[1] < -1.565", "Q_MEZ[1] > -1.576", "Q_MEZ[2] > 1.565", "Q_MEZ[2] < 1.576"]
    expected = [word for condition in near_home for word in ("--expect", condition)]
    assert main(["run", "home_by_net", "--virtual", *expected]) == 0, capsys.readouterr().out
