"""Cameras that a file places."""

import mujoco
import numpy as np
import pytest

from onika.model.camera import CameraBlock
from onika.workcell.composed.camera_spec import add_cameras, add_sky, eye_of, focal_length, is_placed, lenses


@pytest.mark.parametrize(("at", "looks"), [((0, 0, 2), (0, 0, 0)), ((1, 2, 3), (0, 1, 0)), ((0, 0, 0), (0, 0, 1))])
def test_a_camera_looks_where_it_is_to_look(at, looks):  # R-F05
    spec = mujoco.MjSpec()
    camera = CameraBlock("eye", at=at, looks=looks, lens=50.0)
    add_cameras(spec, [camera, CameraBlock("other", on="nowhere", at=at, looks=looks), CameraBlock("view")])
    add_sky(spec)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    axes = data.cam(eye_of(camera)).xmat.reshape(3, 3)
    way = np.subtract(looks, at) / np.linalg.norm(np.subtract(looks, at))
    assert np.allclose(-axes[:, 2], way)
    assert np.linalg.det(axes) == pytest.approx(1.0)
    assert lenses(model) == {"camera.eye": 50.0}


def test_what_a_camera_is_called_in_its_document():
    assert eye_of(CameraBlock("eye", at=(0, 0, 0))) == "camera.eye"
    assert eye_of(CameraBlock("eye", "table.side")) == "table.side"
    assert eye_of(CameraBlock("eye")) == "eye"
    assert [is_placed(name) for name in ("camera.eye", "left.camera.eye", "eye", "table.side")] == [
        True,
        True,
        False,
        False,
    ]


def test_at_45_degrees_from_the_middle_lies_the_focal_length():
    assert focal_length(90.0, 240) == pytest.approx(120.0)
