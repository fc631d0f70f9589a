"""Cameras at work while time does not wait for them."""

from time import monotonic_ns

import pytest

from kit.worlds.filmed_cells import filmed
from onika.workcell.filmed.filmed_world import FilmedWorld

STEP_NS = 5_000_000


def until(world, is_done, patience_s=20.0):
    """Let the world go on beside the clock until something is so."""
    began = monotonic_ns()
    while not is_done():
        if monotonic_ns() - began > patience_s * 1e9:
            pytest.fail("nothing came")
        world.step(monotonic_ns() - began)
        if world.take_events():
            pytest.skip("this machine cannot render")


def test_pictures_come_beside_the_clock_also_in_a_small_form_where_somebody_looks():  # R-F05, R-F08
    world = FilmedWorld(filmed())
    world.look("above", True)
    world.show("eye_left", True)
    world.show("nothing", True)
    slowest = 0
    small = {}

    def is_done():
        nonlocal slowest
        began = monotonic_ns()
        world.step(world.now_ns + STEP_NS)
        slowest = max(slowest, monotonic_ns() - began)
        small.update(world.take_small())
        return world.state("above")[2] > 2 and "eye_left" in small

    until(world, is_done)
    assert world.picture("above").any()
    number, taken_ns, file = small["eye_left"]
    assert (number, file[:4]) in [(number, b"\x89PNG"), (number, b"\xff\xd8\xff\xe0")]
    assert 0 <= taken_ns <= world.now_ns
    assert set(small) == {"eye_left"}
    for device in ("above", "eye_left"):
        world.look(device, False)
        world.show(device, False)
    world.step(world.now_ns + 200_000_000)
    assert world.state("above")[2:].tolist() == [0.0, 0.0]
