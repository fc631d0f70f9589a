"""Fingers that are brought to a posture, and may meet something on the way."""

import numpy as np
import pytest

from onika.laws.path import quintic
from onika.ring.device import DeviceOrder
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.testing.bench import Bench
from onika.workcell.cell.file_world import FileWorld

CODE = shipped() / "arms" / "module" / "preshape.py"
LINE = "0.1 0.1 0.1 0.5 0.5 0.5 0.3 0.3 0.3 1"


def bench_of(**local):
    limits = {"NDOF": 9, "QMIN": np.full(9, -1.0), "QMAX": np.ones(9), "Q^_MAX": np.full(9, 2.0)}
    return Bench(CODE, frequency=250, constants=limits, local=local).init()


def followed(bench, line=LINE, stops_at=9.0):
    """The references on the way of fingers that follow, but are stopped by something."""
    seen = []
    bench.on(line)
    while bench.finished is None and len(seen) < 2000:
        bench.cycle()
        seen.append(bench["Q_REF"].copy())
        bench["Q_MEZ"] = np.minimum(bench["Q_REF"], stops_at)
    return np.array(seen)


def test_all_fingers_come_to_the_posture():  # R-K04, R-K05
    bench = bench_of()
    way = followed(bench)
    assert way[-1] == pytest.approx([0.1] * 3 + [0.5] * 3 + [0.3] * 3)
    assert bench["Q^_REF"] == pytest.approx(np.zeros(9), abs=1e-9)
    assert len(way) == pytest.approx(250, abs=3)
    assert (np.diff(way, axis=0) >= 0).all()


def test_a_finger_may_begin_later_than_the_one_before_it():  # R-K05
    way = followed(bench_of(LATER="0.2"))
    first, second, third = (np.flatnonzero(way[:, finger] > 1e-6)[0] for finger in range(3))
    assert (second - first, third - second) == (50, 50)
    assert len(way) == pytest.approx(350, abs=3)


def test_fingers_that_meet_something_stay_there_and_go_on_pressing():  # R-K04
    bench = bench_of()
    way = followed(bench, stops_at=0.2)
    assert bench.finished is not None
    assert way[-1][3:6] == pytest.approx([0.5] * 3)
    assert len(way) == pytest.approx(250 + 75, abs=3)


def test_what_is_too_fast_takes_longer_and_is_told():
    bench = bench_of()
    way = followed(bench, LINE[:-1] + "0.1")
    assert len(way) > 150
    assert "too short" in str(bench.warnings[0])


def posture_of(name):
    site = open_site((), {}, None)
    return np.array(site.onikon(name, site.syntax()[0])[0].values[0])


@pytest.mark.parametrize("seed", [1, 2])
def test_the_shipped_hand_turns_a_knob_that_stands_a_little_elsewhere(seed):  # R-K04
    world = FileWorld(gather_world("bower", open_site((), {}, None))[0], seed)
    world.claim("fingers_above", 1)
    here = np.zeros(9)
    for name in ("fingers_ready", "fingers_grip", "fingers_turn", "fingers_let_go"):
        way = posture_of(name) - here
        for k in range(1, 251):
            share, _ = quintic(k / 250, 1.0)
            world.command("fingers_above", 1, DeviceOrder.DRIVE, [*(here + share * way), *np.zeros(9)])
            world.step(world.now_ns + 2 * world.step_ns)
        here = here + way
    _, _, height, w, x, y, z = world.state("knob_at")[2:]
    assert np.degrees(2 * np.arctan2(z, w)) > 35
    assert (height, x, y) == pytest.approx((0.15, 0.0, 0.0), abs=2e-3)
