"""Cameras as files say them."""

from onika.model.camera import CameraBlock


def test_a_camera_of_which_nothing_is_said_takes_ten_small_pictures_a_second():  # R-F05, R-F08
    camera = CameraBlock("eye")
    assert (camera.size, camera.rate, camera.lens, camera.at) == ((320, 240), 10.0, 45.0, ())
