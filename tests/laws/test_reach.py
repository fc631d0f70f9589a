import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.arm import ArmModel
from onika.laws.frames import nine_of_pose, pose_of_nine, rotation_of_rpy
from onika.laws.reach import poses, postures, postures_along, transfer, why_not
from onika.laws.robot import published

PUMA, SCARA = published(puma560, 0, 0, 0, 0), published(adept_one, 0, 0, 0, 0)
PLAIN = {key: value.tolist() if isinstance(value, np.ndarray) else value for key, value in SCARA.items()}
ABOVE_TRIANGLE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)
ABOVE_SQUARE = (-0.579571, -0.625356, 2.700589, 0.0, 1.06636, 0.991226)
BOX = (0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.7, 0.28, -0.3346)
UNNAMED = {**PUMA, "ROBOT": "nobody"}
"""The same arm where no closed form is known."""
ARMS = pytest.mark.parametrize("constants", [PUMA, SCARA, UNNAMED], ids=["puma", "scara", "unnamed"])
TRIED, IMPROVED, STEPS = 4000, 10, 40
CLOSE = 1e-7


def pose_of(constants, q):
    return ArmModel(constants["SCREW"], base=constants["BASE"], tool=constants["TOOL"]).forward(q)


@pytest.mark.parametrize("constants", [SCARA, PLAIN], ids=["arrays", "lists"])
def test_targets_beyond_reach_are_named_each_with_its_reason(constants):  # law 26, R-E09, R-K03
    far, low = (*BOX[:6], 0.7, 0.45, -0.3346), (*BOX[:8], -0.40)
    targets = [("cartesian object", (*point, 1.4)) for point in (BOX, far, low)]
    targets += [("joint object", q) for q in ([0.1, 0.2, 0.3, 0.0, 1.0], [0.1, 3.0, 0.2, 0.0], [0.1])]
    reachable, out, deep, pulled, bent, short = why_not(constants, targets)
    assert reachable is None
    assert out.startswith("out of reach: the quill would be 0.832 m")
    assert deep == "joint 3 would stand at 0.330 m, beyond 0.000..0.295"
    assert pulled == "joint 3 at 0.300 m is beyond 0.295"
    assert bent == "joint 2 at 3.00 rad is beyond 2.57"
    assert short == "expected 4 joint values, found 1"


def test_a_relative_target_is_judged_from_where_the_one_before_it_ends():  # law 26, R-D25
    up, on = ("relative object", (0.0, 0.0, 0.1, 1.0)), ("relative object", (0.6, 0.0, 0.0, 1.0))
    box, triangle = ("cartesian object", (*BOX, 1.4)), ("joint object", (*ABOVE_TRIANGLE, 2.3))
    assert why_not(PUMA, [box, up, up]) == [None, None, None] and why_not(PUMA, [triangle, up]) == [None, None]
    assert "reach" in why_not(PUMA, [box, up, on])[2]
    assert "reach" in why_not(PUMA, [triangle, on])[1]


def test_where_nobody_knows_where_a_relative_target_begins_nobody_judges_it():  # law 26, R-D25
    far, unreachable = ("relative object", (2.0, 2.0, 0.0, 1.0)), ("cartesian object", (*BOX[:6], 9.0, 0.0, 0.0, 1.0))
    assert why_not(PUMA, [far, far]) == [None, None]
    assert why_not(PUMA, [("cartesian object", (*BOX, 1.4)), ("", []), far]) == [None, None, None]
    assert why_not(PUMA, [unreachable, far])[1] is None  # what is wrong is told of the first alone


def test_a_joint_beyond_its_limit_by_a_hair_is_told_with_numbers_that_differ():  # R-X02
    beyond, at = SCARA["QMAX"][1] + 1e-5, SCARA["QMAX"][1]
    reasons = why_not(SCARA, [("joint object", [0.1, q, 0.2, 0.0]) for q in (beyond, at)])
    assert reasons == [f"joint 2 at {beyond:.5f} rad is beyond {at:.5f}", None]


def test_the_same_cartesian_target_is_within_reach_of_both():  # R-E09
    assert why_not(SCARA, [("cartesian object", BOX)]) == why_not(PUMA, [("cartesian object", BOX)]) == [None]


def test_a_joint_target_is_the_pose_of_its_tool_whatever_stands_behind_it():
    (nine,) = poses(PUMA, [(*ABOVE_TRIANGLE, 2.3)])
    assert nine == pytest.approx([0, 0, -1, 0, 1, 0, 0.7, 0.28, -0.125], abs=1e-4)


@pytest.mark.parametrize("target", [ABOVE_TRIANGLE, ABOVE_SQUARE])
def test_another_arm_brings_the_tool_to_the_same_place(target):  # law 26, R-E09
    (values,) = transfer(PUMA, SCARA, [(*target, 1.0)])
    assert values.shape == (4,)
    assert pose_of(SCARA, values) == pytest.approx(pose_of(PUMA, target), abs=1e-4)


def test_what_another_arm_cannot_take_is_explained_and_hinders_no_other():  # law 26
    up, triangle = transfer(PUMA, SCARA, [puma560.HOME, ABOVE_TRIANGLE])
    assert up == "the hand would lean 180 degrees; this arm only holds it upright, fingers down"
    assert not isinstance(triangle, str)


def test_the_way_back_ends_at_the_same_place():
    (there,) = transfer(PUMA, SCARA, [ABOVE_TRIANGLE])
    (back,) = transfer(SCARA, PUMA, [there], near=ABOVE_TRIANGLE)
    assert back == pytest.approx(ABOVE_TRIANGLE, abs=1e-4)


def test_the_same_arm_in_another_mode_keeps_its_joint_targets_to_the_last_digit():  # law 18
    assert transfer(PUMA, dict(PUMA), [(*puma560.HOME, 2.0)])[0].tolist() == puma560.HOME.tolist()


def test_the_same_arm_elsewhere_turns_its_joints_to_the_same_place_in_the_world():
    moved = published(puma560, 0.05, 0.0, 0.0, 10.0)
    (values,) = transfer(PUMA, moved, [ABOVE_TRIANGLE])
    assert pose_of(moved, values) == pytest.approx(pose_of(PUMA, ABOVE_TRIANGLE), abs=1e-6)


def test_the_elbow_stays_on_its_side_from_target_to_target():
    poses = [nine_of_pose(pose_of(PUMA, q)) for q in (ABOVE_TRIANGLE, ABOVE_SQUARE) * 2]
    for elbow in (1.0, -1.0):
        near = np.array([-0.5 * elbow, 1.4 * elbow, 0.0, 0.0])
        assert {float(np.sign(q[1])) for q in postures(SCARA, poses, near)} == {elbow}


def test_postures_along_a_way_are_looked_for_as_they_are_asked_for():  # law 26
    (pose,) = poses(SCARA, [(0.4, 0.9, 0.05, -0.8)])
    way = iter([pose, pose])
    assert np.array_equal(next(postures_along(SCARA, way)), postures(SCARA, [pose])[0])
    assert len(list(way)) == 1


def test_nine_numbers_that_are_no_pose_are_a_reason():
    (why,) = postures(SCARA, [(0, 0, -1, 0, 0, 1, 0.7, 0, -0.2)])
    assert why == "expected approach and normal square to each other, found a · n = -1"


def test_a_guarded_motion_is_judged_as_any_to_a_pose_and_a_relative_one_begins_at_its_end():  # law 26, R-D25
    above, limits = [0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.7, 0.28, -0.125, 3.0], [20.0, 10.0]
    far = [*above[:6], 3.0, *above[7:]]
    targets = [("guarded object", [*target, *limits]) for target in (above, far)]
    reasons = why_not(PUMA, targets)
    assert reasons[0] is None and "out of reach" in reasons[1]
    assert why_not(PUMA, [targets[0], ("relative object", [0.0, 0.0, 1.2, 1.0])])[1]


class BruteForce:
    """An arm whose postures are tried without knowing anything of it but where its tool goes."""

    def __init__(self, constants, rng):
        self.low, self.high = np.asarray(constants["QMIN"]), np.asarray(constants["QMAX"])
        self.arm = ArmModel(constants["SCREW"], base=constants["BASE"], tool=constants["TOOL"])
        self.tried = rng.uniform(self.low, self.high, (TRIED, len(self.low)))
        self.seen = np.array([self.arm.forward(q) for q in self.tried])

    def comes_to(self, pose):
        """Whether a posture within the limits brings the tool there."""
        away = np.linalg.norm((self.seen - pose).reshape(TRIED, 16), axis=1)
        return any(self._improved(self.tried[k], pose) for k in np.argsort(away)[:IMPROVED])

    def _improved(self, start, pose):
        q = start.copy()
        for _ in range(STEPS):
            lacks = self._lacking(q, pose)
            if np.linalg.norm(lacks) < CLOSE:
                return True
            jacobian = self.arm.jacobian(q)
            step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + 1e-9 * np.eye(6), lacks)
            q = np.clip(q + np.clip(step, -0.3, 0.3), self.low, self.high)
        return False

    def _lacking(self, q, pose):
        here = self.arm.forward(q)
        turned = sum(np.cross(here[:3, k], pose[:3, k]) for k in range(3)) / 2.0
        return np.concatenate([pose[:3, 3] - here[:3, 3], turned])


@ARMS
def test_where_a_posture_brings_the_tool_pre_flight_lets_it_go(constants):  # law 26, R-X19
    brute = BruteForce(constants, np.random.default_rng(1))
    targets = [("cartesian object", (*nine_of_pose(pose), 1.0)) for pose in brute.seen[:150]]
    refused = [reason for reason in why_not(constants, targets) if reason is not None]
    assert refused == []


@pytest.mark.parametrize("count", [12, pytest.param(150, marks=pytest.mark.slow)])
@ARMS
def test_what_pre_flight_lets_go_a_posture_within_the_limits_does_and_what_it_refuses_none(
    constants, count
):  # law 26, R-X19
    rng = np.random.default_rng(2)
    brute = BruteForce(constants, rng)
    is_upright = len(brute.low) < 6
    counts = {True: 0, False: 0}
    confirmed = 0
    for _ in range(count):
        pose = np.eye(4)
        around = rng.uniform(-np.pi, np.pi, 3)
        pose[:3, :3] = rotation_of_rpy(np.pi, 0.0, around[2]) if is_upright else rotation_of_rpy(*around)
        pose[:3, 3] = rng.uniform([-0.9, -0.9, -0.4], [0.9, 0.9, 0.9])
        nine = nine_of_pose(pose)
        (reason,) = why_not(constants, [("cartesian object", (*nine, 1.0))])
        if reason is None:
            (q,) = postures(constants, [nine])
            assert (q >= brute.low - 1e-9).all() and (q <= brute.high + 1e-9).all()
            assert brute.arm.forward(q) == pytest.approx(pose_of_nine(nine), abs=1e-6)
            confirmed += brute.comes_to(pose)
        else:
            assert not brute.comes_to(pose), (nine, reason)
        counts[reason is None] += 1
    assert min(counts.values()) >= 2
    assert confirmed >= 0.8 * counts[True]  # brute force finds what there is, so that its no means something
