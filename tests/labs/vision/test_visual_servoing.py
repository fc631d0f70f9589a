"""Pictures, what is seen in them, and motions that follow them."""

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

MODULES = shipped() / "vision" / "module"
H, W, FOCAL = 60, 80, 100.0
IDENTITY = {"H": (H,), "W": (W,), "FOCAL": (FOCAL,), "RATE": (10.0,)}
MIDDLE = np.array((W / 2, H / 2)) - 0.5


def box(u, v, rgb=(30, 60, 190)):
    """A brown ground with a box of 24 pixels whose upper left corner is at (u, v)."""
    pixels = np.full((H, W, 3), (160, 130, 90), np.uint8)
    top, left = max(round(v), 0), max(round(u), 0)
    pixels[top : max(round(v) + 24, 0), left : max(round(u) + 24, 0)] = rgb
    return pixels


def camera():
    return BenchDevice(["number", "age"], (), IDENTITY, (H, W))


def test_a_camera_passes_its_pictures_on_with_their_number_and_age():  # R-F05
    device = camera()
    bench = Bench(MODULES / "camera.py", frequency=20, device=device, constants={"H": H, "W": W}).init()
    assert (bench["H"], bench["W"], bench["FOCAL"]) == (H, W, FOCAL)
    bench.on().cycle()
    assert not bench["IMG"].any()
    device.pixels[:] = box(10, 10)
    device.state[:] = 1, 0.03
    bench.cycle()
    assert np.array_equal(bench["IMG"], box(10, 10))
    assert bench["IMG_T"].tolist() == [1.0, 0.03]


@pytest.mark.parametrize(
    ("state", "drive", "why"),
    [((1, 5.1), 0, "no picture came for 5.1 s"), ((0, 0), 2, "the camera can take no pictures here")],
)
def test_a_camera_that_sees_nothing_any_more_is_in_error(state, drive, why):  # R-F05
    device = camera()
    bench = Bench(MODULES / "camera.py", frequency=20, device=device, constants={"H": H, "W": W}).init().on()
    device.state[:] = state
    device.values[1] = drive
    bench.cycle()
    assert bench.state is State.ERROR
    assert why in bench.why


def test_a_camera_is_waited_for_but_not_for_ever():
    bench = Bench(MODULES / "camera.py", frequency=20, device=camera(), constants={"H": H, "W": W}).init().on()
    assert bench.cycle(500).state is State.ON
    assert bench.cycle(200).state is State.ERROR


def test_what_takes_no_pictures_is_no_camera():
    bench = Bench(MODULES / "camera.py", frequency=20, device=BenchDevice(["q"]), constants={"H": H, "W": W}).init()
    assert "expected a camera, found a device that takes no pictures" in bench.why


def test_the_middle_of_a_colour_stays_where_nothing_is_seen():  # R-K04
    sizes = {"H": H, "W": W}
    bench = Bench(MODULES / "blob.py", frequency=20, constants=sizes, local={"COLOUR": (0, 0, 1)}).init()
    bench["IMG"], bench["IMG_T"] = box(20, 10), [1, 0.0]
    bench.on().cycle()
    assert (bench["UV"].tolist(), bench["AREA"]) == ([31.5, 21.5], 576.0)
    bench["IMG"], bench["IMG_T"] = box(20, 10, (40, 160, 40)), [2, 0.0]
    bench.cycle()
    assert (bench["UV"].tolist(), bench["AREA"]) == ([31.5, 21.5], 0.0)
    bench = Bench(MODULES / "blob.py", frequency=20, constants=sizes, local={"COLOUR": (1, 1, 1)}).init()
    assert "expected a colour, found grey" in bench.why


def servoed(name, show, line="", frequency=50, **local):
    """The module moves a camera 0.2 m above a plane; `show` gives it what it sees of the way so far (pixels)."""
    bench = Bench(MODULES / name, frequency=frequency, constants={"H": H, "W": W, "FOCAL": FOCAL}, local=local).init()
    way = np.zeros(2)
    show(bench, way, 1)
    bench.on(line)
    for step in range(1, 400):
        bench.cycle()
        if bench.finished is not None or bench.state is State.ERROR:
            return bench, way, step / frequency
        way += bench["V_REF"][:2] / frequency * FOCAL / 0.2
        if step % 5 == 0:
            show(bench, way, 1 + step // 5)
    return bench, way, step / frequency


def test_a_point_that_is_seen_comes_to_its_place():  # R-K04, R-F05
    def show(bench, way, number):
        bench["UV"], bench["AREA"], bench["IMG_T"] = MIDDLE + np.array((25.0, -18.0)) - way, 100.0, [number, 0.0]

    bench, way, seconds = servoed("ibvs.py", show, DEPTH=0.2)
    assert bench.finished is not None
    assert np.allclose(way, (25.0, -18.0), atol=2.0)
    assert seconds < 3.0
    assert bench["V_REF"].tolist() == [0.0] * 6


@pytest.mark.parametrize(
    ("area", "age", "local", "why"),
    [
        (0.0, 0.0, {}, "for 3 s nothing was seen"),
        (5.0, 0.6, {}, "for 3 s nothing was seen"),
        (5.0, 0.0, {"MOST": 1.0, "SPEED": 0.001}, "after 1 s it is still 24"),
    ],
)
def test_where_nothing_is_seen_or_it_takes_too_long_the_arm_stays(area, age, local, why):  # R-K04
    def show(bench, way, number):
        bench["UV"], bench["AREA"], bench["IMG_T"] = MIDDLE + np.array((25.0, 0.0)) - way, area, [number, age]

    bench, way, _ = servoed("ibvs.py", show, DEPTH=0.2, **local)
    assert bench.state is State.ERROR
    assert why in bench.why
    assert np.abs(way).max() < 1.0


def test_before_the_first_picture_it_waits():
    def show(bench, way, number):
        bench["IMG_T"] = [0.0, 0.0]

    bench, way, _ = servoed("ibvs.py", show)
    assert bench.state is State.ON
    assert not way.any()


def test_a_clicked_point_is_found_again_and_comes_to_the_middle():  # R-F05, R-B10
    def show(bench, way, number):
        u, v = np.array((52.0, 36.0)) - way
        bench["IMG"], bench["IMG_T"] = box(u, v), [number, 0.0]

    bench, way, seconds = servoed("topoint.py", show, "52 36", DEPTH=0.2)
    assert bench.finished is not None
    assert np.allclose(way, np.array((52.0, 36.0)) - MIDDLE, atol=2.0)
    assert np.allclose(bench["UV"], MIDDLE, atol=2.0)
    assert seconds < 3.0


@pytest.mark.parametrize(
    ("line", "gone_after", "why"),
    [("15 15", 99, "there is nothing at 15 15"), ("52 36", 2, "the point was lost for 3 s")],
)
def test_a_point_that_cannot_be_found_stops_it(line, gone_after, why):  # R-F05
    def show(bench, way, number):
        u, v = np.array((52.0, 36.0)) - way
        bench["IMG"], bench["IMG_T"] = box(u, v) if number <= gone_after else box(200, 200), [number, 0.0]

    bench, _, _ = servoed("topoint.py", show, line, DEPTH=0.2)
    assert bench.state is State.ERROR
    assert why in bench.why


def pursued(seen=lambda _number: 100.0, **local):
    """A base with a camera 0.2 m above the floor, which looks straight ahead; the green place is at (1.5, 0.4)."""
    bench = Bench(MODULES / "pursue.py", frequency=50, constants={"H": H, "W": W, "FOCAL": FOCAL}, local=local).init()
    place, turn = np.zeros(2), 0.0
    bench.on()
    for step in range(1500):
        if step % 5 == 0:
            away = np.array((1.5, 0.4)) - place
            ahead, left = away @ (np.cos(turn), np.sin(turn)), away @ (-np.sin(turn), np.cos(turn))
            bench["UV"] = MIDDLE + FOCAL * np.array((-left, 0.2)) / max(ahead, 0.1)
            bench["AREA"], bench["IMG_T"] = seen(1 + step // 5), [1 + step // 5, 0.0]
        bench.cycle()
        if bench.finished is not None or bench.state is State.ERROR:
            break
        forward, _, rate = bench["V_BASE"]
        turn += rate / 50
        place += forward / 50 * np.array((np.cos(turn), np.sin(turn)))
    return bench, float(np.linalg.norm(np.array((1.5, 0.4)) - place))


def test_a_base_drives_up_to_what_it_sees():  # R-K04
    bench, away = pursued(PLACE=(0.5, 0.5 + 40.0 / H))  # as low as what is 0.5 m away
    assert bench.finished is not None
    assert away == pytest.approx(0.5, abs=0.03)
    assert bench["V_BASE"].tolist() == [0.0] * 3


@pytest.mark.parametrize(
    ("seen", "local", "why"),
    [
        (lambda number: 100.0 if number < 5 else 0.0, {}, "for 3 s nothing was seen"),
        (lambda _number: 100.0, {"MOST": 1.0}, "after 1 s it is still"),
    ],
)
def test_a_base_that_sees_nothing_or_takes_too_long_stays(seen, local, why):  # R-K04
    bench, away = pursued(seen, **local)
    assert bench.state is State.ERROR
    assert why in bench.why
    assert away > 0.7
