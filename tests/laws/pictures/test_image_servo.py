"""A camera that moves until a point is where it should be in its picture."""

import math

import numpy as np
import pytest

from onika.laws.pictures.image_servo import ImageServo

FOCAL, DEPTH, DT = 200.0, 0.4, 0.02


def settled(late_s, gain=3.0, speed=1.0, turn=0.0, error=(80.0, -60.0)):
    """The seconds until the point stays within 2 px, where each picture comes late; and how far it went beyond."""
    servo = ImageServo(FOCAL, DEPTH, gain, turn, speed, 10.0)
    unturned = np.array(((math.cos(turn), math.sin(turn)), (-math.sin(turn), math.cos(turn))))
    way, past, last, beyond = np.zeros(2), [], 0.0, 0.0
    for step in range(400):
        now = step * DT
        past.append(np.array(error) - way * FOCAL / DEPTH)
        if step % 5 == 0:
            behind = max(0, step - round(late_s / DT))
            servo.see(past[behind], behind * DT)
        way = way + DT * (unturned @ servo.move(now, DT))
        away = np.array(error) - way * FOCAL / DEPTH
        beyond = max(beyond, -float(away @ np.array(error)) / 100.0)
        last = now if np.linalg.norm(away) > 2.0 else last
    return last, beyond


@pytest.mark.parametrize("late_s", [0.0, 0.1, 0.2])
def test_it_settles_soon_however_late_pictures_come(late_s):  # R-K04
    seconds, beyond = settled(late_s)
    assert seconds < 1.7
    assert beyond < 0.5


def test_it_goes_no_faster_than_it_may():
    servo = ImageServo(FOCAL, DEPTH, 5.0, 0.0, 0.1, 0.5)
    servo.see(np.array((100.0, 0.0)), 0.0)
    speeds = [servo.move(k * DT, DT)[0] for k in range(30)]
    assert max(speeds) == pytest.approx(0.1)
    assert speeds[0] == pytest.approx(0.01)


def test_a_turned_camera_moves_along_the_axes_of_its_tool():
    assert settled(0.1, turn=2.0) == pytest.approx(settled(0.1))


def test_what_is_lost_lets_it_come_to_rest():
    servo = ImageServo(FOCAL, DEPTH, 3.0, 0.0, 1.0, 10.0)
    servo.see(np.array((50.0, 50.0)), 0.0)
    servo.move(0.0, DT)
    servo.lose()
    for k in range(1, 100):
        speed = servo.move(k * DT, DT)
    assert np.abs(speed).max() < 1e-3
