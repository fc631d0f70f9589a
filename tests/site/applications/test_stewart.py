"""A laboratory of a closed chain: a plate on six legs (requirement K04)."""

import json
from math import cos, radians, sin

import pytest

from onika.cli import main

pytestmark = pytest.mark.site


@pytest.mark.slow  # a page of the guide does the same
def test_the_plate_is_moved_and_the_model_has_it_where_the_legs_say(capsys):  # R-K04
    turned = {(0, 0): cos(radians(20)), (1, 0): sin(radians(20)), (0, 3): 0.0, (1, 3): 0.0, (2, 3): 0.335}
    limits = [
        f"{name}[{row},{column}] {relation} {value + margin:.5f}"
        for name in ("X_MEZ", "X_PLATE")
        for (row, column), value in turned.items()
        for relation, margin in (("<", 1e-4), (">", -1e-4))
    ]
    words = [word for text in limits for word in ("--expect", text)]
    code = main(["run", "plate_tour", "--virtual", "--json", *words])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert (code, result["state"], result["notes"], result["actions_done"]) == (0, "completed", [], 3)
