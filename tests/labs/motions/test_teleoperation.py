"""Teleoperation: strokes of a pad, the speed they mean, the tool and the joints that they lead, a follower."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws import puma560
from onika.laws.frames import pose_of_nine, rotation_of_rpy
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "motions" / "module"
LIMITS = {"NDOF": 6, "QMIN": puma560.QMIN, "QMAX": puma560.QMAX, "Q^_MAX": puma560.QDMAX, "BASE": np.eye(4)}
HOME = np.array(puma560.HOME)
START = pose_of_nine([0, 0, -1, 0, 1, 0, 0.5, 0.1, -0.1])
NAN = float("nan")


def bench_of(name, hz=100, **local):
    bench = Bench(MODULES / f"{name}.py", frequency=hz, constants=LIMITS, local=local).init()
    if name == "lead":
        bench["X_MEZ"] = START
    elif name in ("jjog", "mirror"):
        bench["Q_MEZ"] = HOME
    return bench


def test_strokes_come_one_behind_the_other_then_the_button_and_they_begin_anew():  # R-K07
    bench = bench_of("strokes", STROKES="2:0.5:0.05 -:0:0.02 0:-1:0.03", PRESS=0.02).on()
    rows = [(bench.cycle()["V_RAW"].copy(), bench["BUTTONS"]) for _ in range(14)]
    axes = [(row[2], row[0]) for row, _ in rows]
    assert axes == [(0.5, 0.0)] * 5 + [(0.0, 0.0)] * 2 + [(0.0, -1.0)] * 3 + [(0.0, 0.0)] * 2 + [(0.5, 0.0)] * 2
    assert [button for _, button in rows] == [0] * 10 + [1] * 2 + [0] * 2


@pytest.mark.parametrize("word", ["6:0.5:1", "0:1.5:1", "0:0.5", "0:0.5:0", "x:0.5:1", "0:nan:1", "-1:0.5:1", "-2:0:1"])
def test_a_word_that_is_no_stroke_is_refused(word):
    bench = bench_of("strokes", STROKES=f"0:1:1 {word}")
    assert bench.state is State.ERROR
    assert f"as 2:0.5:1.5, found {word}" in bench.why


def speeds(axis, **local):
    """The speed that one axis means, at each of these pushes."""
    bench = bench_of("deadband", **local).on()
    found = []
    for push in np.linspace(-1, 1, 201):
        bench["V_RAW"] = [push if k == axis else 0.0 for k in range(6)]
        found.append(bench.cycle()["V_REF"].copy())
    return np.array(found)


def test_a_push_means_nothing_near_the_middle_and_all_at_the_end():  # R-K07
    moving, turning = speeds(1, ZONE=0.2, SPEED=0.4, TURN=2), speeds(4, ZONE=0.2, SPEED=0.4, TURN=2)
    assert moving[:, 1] == pytest.approx(-moving[::-1, 1])
    assert (moving[80:121, 1] == 0.0).all() and moving[122, 1] > 0.0
    assert (moving[-1, 1], turning[-1, 4]) == (pytest.approx(0.4), pytest.approx(2.0))
    assert (np.diff(moving[:, 1]) >= 0.0).all() and np.abs(np.diff(moving[:, 1])).max() < 0.02
    assert (moving[:, [0, 2, 3, 4, 5]] == 0.0).all()


def test_the_curve_makes_it_finer_near_the_middle_only():
    fine, plain = speeds(0, ZONE=0, CURVE=1)[:, 0], speeds(0, ZONE=0, CURVE=0)[:, 0]
    assert plain == pytest.approx(0.1 * np.linspace(-1, 1, 201))
    assert fine == pytest.approx(0.1 * np.linspace(-1, 1, 201) ** 3)


def test_an_axis_that_is_no_number_counts_as_let_go():
    bench = bench_of("deadband").on()
    bench["V_RAW"] = [NAN, float("inf"), 1.0, 0, 0, 0]
    assert bench.cycle()["V_REF"].tolist() == pytest.approx([0, 0, 0.1, 0, 0, 0])


def test_a_speed_along_the_tool_is_turned_into_one_of_the_world():  # R-K07
    bench = bench_of("frame").on()
    bench["X_MEZ"], bench["V_REF"] = START, [0, 0, 0.1, 0.2, 0, 0]
    turned = bench.cycle()["V_OUT"]
    assert turned == pytest.approx([0, 0, -0.1, 0, 0.2, 0])  # the tool points down, its normal lies along y


@pytest.mark.parametrize("frame", ["tool", "base", "world"])
def test_turning_changes_no_length(frame):
    base = np.eye(4)
    base[:3, :3] = rotation_of_rpy(0.1, -0.2, 2.0)
    bench = Bench(MODULES / "frame.py", frequency=100, constants={"BASE": base}, local={"FRAME": frame}).init().on()
    bench["X_MEZ"], bench["V_REF"] = START, [1, 2, 3, -1, 0.5, 2]
    turned = bench.cycle()["V_OUT"]
    expected = {"tool": START, "base": base, "world": np.eye(4)}[frame][:3, :3] @ [1, 2, 3]
    assert turned[:3] == pytest.approx(expected)
    assert np.linalg.norm(turned[3:]) == pytest.approx(np.linalg.norm([-1, 0.5, 2]))


def test_a_frame_that_is_none_is_refused():
    assert "expected tool, base or world, found hand" in bench_of("frame", FRAME="hand").why


def jogged(twist, cycles=200, follows=True, **local):
    """Where a tool is led, cycle by cycle."""
    bench = bench_of("lead", **local).on()
    path = [bench["X_REF"].copy()]
    for _ in range(cycles):
        bench["V_REF"] = twist
        if follows:
            bench["X_MEZ"] = bench["X_REF"]
        bench.cycle()
        path.append(bench["X_REF"].copy())
    return bench, np.array(path)


def test_a_tool_is_led_with_a_speed_that_rises_evenly():  # R-K07
    _, path = jogged([0.1, 0, 0, 0, 0, 0], RISE=0.2)
    steps = np.diff(path[:, 0, 3]) * 100
    assert steps[:51] == pytest.approx([min(0.002 * k, 0.1) for k in range(1, 52)])
    assert path[-1][0, 3] - path[0][0, 3] == pytest.approx(0.1 * 2.0 - 0.1 * 0.25, abs=1e-3)


def test_a_tool_is_turned_about_the_axes_of_the_world_and_stays_a_pose():
    _, path = jogged([0, 0, 0, 0, 0, 1.0], TURNRISE=1000.0)
    assert path[-1][:3, :3] == pytest.approx(rotation_of_rpy(0, 0, 2.0) @ START[:3, :3], abs=1e-9)


def test_a_tool_stays_within_its_box_and_near_an_arm_that_does_not_follow():  # R-K07
    _, path = jogged([0.2, 0, 0, 0, 0, 0], HIGH="0.6 2 2")
    assert path[:, 0, 3].max() == pytest.approx(0.6)
    bench, stuck = jogged([0.2, 0.1, 0, 0, 0, 0], follows=False, LEASH=0.03)
    assert np.linalg.norm(stuck[:, :3, 3] - START[:3, 3], axis=1).max() <= 0.03
    bench["X_MEZ"] = stuck[-1]
    assert bench.cycle(20)["X_REF"][0, 3] > stuck[-1][0, 3]


def test_the_button_brings_the_tool_to_rest():  # R-K07
    bench, _ = jogged([0.1, 0, 0, 0, 0, 0], RISE=0.5)
    assert bench.get("speed") == pytest.approx(0.1)
    bench["BUTTONS"] = 1
    places = [bench["X_REF"][0, 3]]
    for _ in range(40):
        bench["X_MEZ"] = bench["X_REF"]
        places.append(bench.cycle()["X_REF"][0, 3])
    assert np.ptp(places[21:]) == pytest.approx(0.0, abs=1e-9)
    assert np.abs(np.diff(places, 2)).max() * 1e4 <= 0.5 + 1e-6
    assert bench.get("speed") == 0.0


def limited(twist, cycles=100, x=0.5, **local):
    """The speeds that a tool may have, cycle by cycle, which follows them."""
    bench = bench_of("twistlimit", **local)
    pose = START.copy()
    pose[0, 3], speeds = x, []
    bench["X_MEZ"] = pose
    bench.on()
    for _ in range(cycles):
        bench["X_MEZ"], bench["V_WISH"] = pose, twist
        speeds.append(bench.cycle()["V_REF"].copy())
        pose[:3, 3] += speeds[-1][:3] / 100.0
    return bench, np.array(speeds), pose


def test_the_speed_of_a_tool_rises_evenly_and_is_none_while_the_button_is_pressed():  # R-K07, R-F05
    bench, speeds, _ = limited([0.1, 0, 0, 0, 0, -0.5], 30)
    assert np.abs(np.diff(speeds[:, 0])).max() <= 0.01 + 1e-12 and np.abs(np.diff(speeds[:, 5])).max() <= 0.05 + 1e-12
    assert speeds[-1] == pytest.approx([0.1, 0, 0, 0, 0, -0.5]) and bench.get("speed") == pytest.approx(0.1)
    bench["BUTTONS"] = 1
    assert bench.cycle(11)["V_REF"] == pytest.approx(np.zeros(6))


def test_a_tool_comes_to_rest_at_the_walls_of_its_box_and_may_come_back_from_outside():  # R-K07, R-F05
    _, speeds, pose = limited([0.2, 0, 0, 0, 0, 0], 300, RISE=0.5, HIGH="0.6 2 2")
    assert pose[0, 3] == pytest.approx(0.6, abs=1e-3) and speeds[-1][0] == pytest.approx(0.0, abs=1e-3)
    assert limited([0.2, 0, 0, 0, 0, 0], x=0.7, HIGH="0.6 2 2")[2][0, 3] == pytest.approx(0.7)
    assert limited([-0.2, 0, 0, 0, 0, 0], x=0.7, HIGH="0.6 2 2")[2][0, 3] < 0.6


def test_a_wish_that_is_no_number_is_no_speed():  # R-K07
    assert limited([NAN, float("inf"), 0, NAN, 0, 0], 20)[1] == pytest.approx(np.zeros((20, 6)))


def test_a_button_ends_a_job_once_it_has_been_pressed_for_a_while():  # R-K07
    bench = bench_of("button", SETTLE=0.05).on()
    for pressed in [0, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1]:
        assert bench.state is State.ON
        bench["BUTTONS"] = pressed
        bench.cycle()
    assert (bench.state, bench.finished.flow) == (State.OFF, 0)


def test_a_speed_that_is_no_number_leads_nowhere():
    _, path = jogged([NAN, float("inf"), 0, NAN, 0, 0], 20)
    assert path[-1] == pytest.approx(START)


def led(push, cycles, joint=1, hz=100, **local):
    bench = bench_of("jjog", hz, **local).on(str(joint))
    places, rates = [bench["Q_REF"].copy()], []
    for _ in range(cycles):
        bench["V_RAW"] = [push, 0, 0, 0, 0, 0]
        bench.cycle()
        places.append(bench["Q_REF"].copy())
        rates.append(bench["Q^_REF"].copy())
    return bench, np.array(places), np.array(rates)


def test_one_joint_is_led_and_says_how_fast_it_goes():  # R-K07
    _, places, rates = led(0.5, 100, joint=3, SPEED=0.2)
    assert np.flatnonzero(np.ptp(places, axis=0)).tolist() == [2]
    assert rates[-1][2] == pytest.approx(0.1 * puma560.QDMAX[2])
    assert np.diff(places[:, 2]) * 100 == pytest.approx(rates[:, 2])


@settings(max_examples=examples(20), deadline=None)
@given(st.lists(st.floats(-2, 2), min_size=1, max_size=8), st.sampled_from([50, 250]), st.integers(1, 6))
def test_a_joint_is_never_led_beyond_its_limits_nor_stopped_more_sharply_than_it_may(pushes, hz, joint):  # R-K07
    bench = bench_of("jjog", hz, SPEED=1.0, RISE=0.3).on(str(joint))
    fastest, rates = float(puma560.QDMAX[joint - 1]), [0.0]
    for push in pushes:
        bench["V_RAW"] = [push, 0, 0, 0, 0, 0]
        for _ in range(hz):
            rates.append(bench.cycle()["Q^_REF"][joint - 1])
            place = bench["Q_REF"][joint - 1]
            assert puma560.QMIN[joint - 1] - 1e-9 <= place <= puma560.QMAX[joint - 1] + 1e-9
    assert np.abs(rates).max() <= fastest + 1e-9
    assert np.abs(np.diff(rates)).max() * hz <= fastest / 0.3 * 1.05


def test_a_joint_is_led_up_to_its_limit():
    _, places, _ = led(1.0, 3000, SPEED=0.5)
    assert places[-1][0] == pytest.approx(puma560.QMAX[0], abs=0.01)


def test_the_button_brings_the_joint_to_rest_and_ends_it():
    bench, places, _ = led(1.0, 100)
    bench["BUTTONS"] = 1
    bench.cycle(1000)
    assert bench.finished.flow == 0
    assert bench["Q_REF"][0] - places[-1][0] == pytest.approx(0.2 * puma560.QDMAX[0] * 0.15, rel=0.1)


@pytest.mark.parametrize(("name", "line"), [("button", ""), ("jjog", "1"), ("teach", "path.csv")])
def test_a_button_that_is_pressed_already_ends_nothing_before_it_was_let_go(name, line, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    bench = bench_of(name)
    bench["BUTTONS"] = 1
    assert bench.on(line).cycle(200).state is State.ON
    for pressed in (0, 1):
        bench["BUTTONS"] = pressed
        bench.cycle(60)
    assert bench.finished is not None


def test_a_joint_that_the_arm_has_not_is_asked_for_again():  # R-A10
    assert bench_of("jjog").on("7").state is State.ASKING


def mirrored(course, **local):
    bench = bench_of("mirror", **local)
    bench["Q_LEAD"] = np.full(6, 0.5)
    bench.on()
    rows = []
    for lead in course:
        bench["Q_LEAD"] = np.full(6, 0.5) + lead
        rows.append(bench.cycle()["Q_REF"].copy())
    return np.array(rows), bench


@pytest.mark.parametrize("scale", [1.0, 0.5, -1.0])
def test_a_follower_does_what_the_leader_does_larger_or_smaller(scale):  # R-K07
    course = 0.1 * np.sin(np.linspace(0, np.pi, 200))
    rows, bench = mirrored(course, SCALE=scale)
    assert rows - HOME == pytest.approx(np.outer(scale * course, np.ones(6)))
    assert bench["Q^_REF"] == pytest.approx((rows[-1] - rows[-2]) * 100)


def test_a_leader_that_jumps_is_followed_within_limits_and_speeds_only():
    rows, _ = mirrored([9.0] * 2000, SPEED=0.3)
    steps = np.abs(np.diff(rows, axis=0, prepend=HOME[None])) * 100
    assert (steps <= 0.3 * np.array(puma560.QDMAX) + 1e-9).all()
    assert rows[-1] == pytest.approx(puma560.QMAX)


def test_a_leader_that_is_no_number_is_not_followed():
    rows, _ = mirrored([NAN, float("inf"), 0.0])
    assert rows == pytest.approx(np.array([HOME] * 3))


def pushed(bench, *pushes, held=1.0, cycles=1, scale=1.0, frame=0, button=0.0):
    """The speed after each of these pushes, each as a line brings it."""
    speeds = []
    for push in pushes:
        bench["PAD"] = [bench["PAD"][0] + 1, held, scale, frame, button, *push]
        speeds.append(bench.cycle(cycles)["V_REF"].copy())
    return speeds


FREE, FORWARD = [0.0] * 6, [1.0, 0, 0, 0, 0, 0]


def pad_bench(**local):
    bench = Bench(MODULES / "pad.py", frequency=100, constants={"BASE": np.eye(4)}, local=local).init()
    bench["X_MEZ"] = START
    bench.on()
    pushed(bench, FREE, held=0.0)
    return bench


def test_a_push_means_a_speed_only_while_the_dead_man_is_held():  # R-K07, R-F05
    bench = pad_bench()
    assert pushed(bench, FORWARD)[0] == pytest.approx([0.1, 0, 0, 0, 0, 0])
    assert pushed(bench, FORWARD, held=0.0)[0] == pytest.approx(np.zeros(6))
    assert pushed(bench, [0, 0, 0, 0, 0, -1.0], scale=0.5)[0] == pytest.approx([0, 0, 0, 0, 0, -0.25])
    assert bench.get("held") == 1


def test_a_push_is_believed_for_a_tenth_of_a_second():  # R-K07, R-F05
    bench = pad_bench()
    pushed(bench, FORWARD)
    moving = [bench.cycle()["V_REF"][0] > 0 for _ in range(20)]
    assert moving == [True] * 9 + [False] * 11


def test_a_push_is_meant_along_the_axes_of_the_tool_where_the_person_says_so():  # R-K07, R-F05
    assert pushed(pad_bench(), FORWARD, frame=1)[0] == pytest.approx([0, 0.1, 0, 0, 0, 0])
    assert pushed(pad_bench(), FORWARD, frame=2)[0] == pytest.approx([0.1, 0, 0, 0, 0, 0])


@settings(max_examples=examples(30), deadline=None)
@given(st.lists(st.floats() | st.sampled_from([0.0, 1.0, 2.0, NAN]), min_size=10, max_size=10))
def test_whatever_is_pushed_no_speed_is_beyond_its_limit(numbers):  # R-K07, R-F05
    bench = pad_bench()
    bench["PAD"] = [bench["PAD"][0] + 1, 1.0, *numbers[1:]]
    speed = bench.cycle()["V_REF"]
    assert bench.get("held") == 1
    assert np.linalg.norm(speed[:3]) <= 0.1 + 1e-9
    assert np.linalg.norm(speed[3:]) <= 0.5 + 1e-9


def test_a_press_counts_without_the_dead_man_and_an_old_one_does_not():  # R-K07
    bench = pad_bench()
    pushed(bench, FREE, held=0.0, button=1.0)
    assert bench["BUTTONS"] == 1
    assert bench.cycle(12)["BUTTONS"] == 0
    bench.off().on()
    assert bench.cycle()["BUTTONS"] == 0
