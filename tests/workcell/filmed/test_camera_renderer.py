"""The process that renders, from the side of its world."""

import os
import signal

import numpy as np
import pytest

from kit.worlds.filmed_cells import filmed
from onika.workcell.filmed.camera_messages import Exposure, Film, laid_out
from onika.workcell.filmed.camera_renderer import WAYS, CameraRenderer
from onika.workcell.filmed.filmed_world import FilmedWorld

PATIENCE_S = 20.0


def exposure(world):
    return Exposure(0, 7, dict(world._stands.acting), world._plant.data.qpos.tobytes(), (), True)


def test_where_one_way_fails_the_next_is_tried_and_a_dead_process_says_why():  # R-F05
    world = FilmedWorld(filmed())
    renderer = CameraRenderer(Film(filmed(), laid_out([("camera.above", (48, 64))])), ("nothing", *WAYS))
    try:
        renderer.ask(exposure(world))
        assert renderer.owed == {0}
        (answer,) = renderer.answers(PATIENCE_S)
        if answer.why is not None:
            pytest.skip("this machine cannot render")
        assert (answer.eye, answer.taken_ns, bool(answer.small)) == (0, 7, True)
        assert np.ptp(renderer.pixels[0]) > 100
        renderer.ask(exposure(world))
        renderer._ways.clear()
        os.kill(renderer._process.pid, signal.SIGKILL)
        answers = [*renderer.answers(PATIENCE_S)]
        assert answers[-1].why is None or answers[-1].why.key == "workcell.no_graphics"
        renderer.ask(exposure(world))
        (answer,) = renderer.answers(PATIENCE_S)
        assert answer.why.key == "workcell.no_graphics"
    finally:
        renderer.close()
