"""Control of any arm by its constants alone: computed torque, resolved rate, a spring at the tool, payload, home."""

import mujoco
import numpy as np
import pytest

from kit.worlds.mjcf_arms import ARMS
from onika.laws import puma560
from onika.laws.arm import ArmModel
from onika.laws.path import quintic
from onika.laws.textbook import serial_arm
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "arms" / "module"


def known(arm):
    return arm.constants | {"LOAD": np.zeros(4)}


def bench_of(task, arm, frequency=500, **local):
    return Bench(MODULES / f"{task}.py", frequency=frequency, constants=known(arm), local=local).init()


class Simulated:
    """An arm that MuJoCo moves, 2 ms a step, with torques as they come."""

    def __init__(self, arm, q):
        self.model, self.data = arm.model, arm.data_at(np.asarray(q, dtype=float))
        self.tool = self.data.site("tool")

    def step(self, torque):
        self.data.qfrc_applied[:] = torque
        mujoco.mj_step(self.model, self.data)

    @property
    def q(self):
        return self.data.qpos.copy()

    @property
    def qd(self):
        return self.data.qvel.copy()


@pytest.mark.parametrize("name", sorted(ARMS))
def test_any_arm_follows_its_reference_by_computed_torque_without_tuning(name):  # R-X19, R-K05
    arm = ARMS[name]
    start = arm.constants["HOME"]
    way = np.where(start > 0.2, -0.3, 0.3)
    simulated, bench = Simulated(arm, start), bench_of("comptorque", arm)
    bench["Q_REF"], bench["Q_MEZ"] = start, start
    bench.on()
    worst = 0.0
    for k in range(700):
        share, rate = quintic(0.002 * k, 1.0)
        bench["Q_REF"], bench["Q^_REF"] = start + share * way, rate * way
        bench["Q_MEZ"], bench["Q^_MEZ"] = simulated.q, simulated.qd
        bench.cycle()
        simulated.step(bench["TAU_REF"])
        worst = max(worst, float(np.abs(simulated.q - start - share * way).max()))
    assert worst < 4e-3  # rad, m: among them one cycle of delay
    assert np.abs(simulated.q - start - way).max() < 1e-4


def test_computed_torque_only_brakes_until_a_reference_is_in_force():  # law 3: nothing tears the arm away
    arm = ARMS["seven"]
    q, simulated = np.full(7, 0.4), Simulated(arm, np.full(7, 0.4))
    bench = bench_of("comptorque", arm)
    bench["Q_REF"], bench["Q_MEZ"] = np.full(7, 2.0), q
    bench.forget("Q_REF").on()
    for _ in range(200):
        bench["Q_MEZ"], bench["Q^_MEZ"] = simulated.q, simulated.qd
        bench.cycle()
        simulated.step(bench["TAU_REF"])
    assert np.abs(simulated.q - q).max() < 1e-3
    bench["Q_REF"] = simulated.q + 0.001
    expected = arm.inertia(simulated.q) @ np.full(7, 1.6)
    bench["Q_MEZ"], bench["Q^_MEZ"] = simulated.q, np.zeros(7)
    bench.cycle()
    assert bench["TAU_REF"] - arm.data_at(simulated.q).qfrc_bias == pytest.approx(expected, abs=1e-9)


def test_friction_is_paid_for_by_the_wanted_speed():
    arm = ARMS["five"]
    constants = known(arm) | {"LINK": arm.constants["LINK"].copy()}
    constants["LINK"][:, 12] = 3.0
    bench = Bench(MODULES / "comptorque.py", frequency=500, constants=constants).init()
    bench["Q_REF"], bench["Q^_REF"], bench["Q^_MEZ"] = np.zeros(5), np.ones(5), np.ones(5)
    still = bench_of("comptorque", arm)
    still["Q_REF"], still["Q^_REF"], still["Q^_MEZ"] = np.zeros(5), np.ones(5), np.ones(5)
    assert bench.on()["TAU_REF"] - still.on()["TAU_REF"] == pytest.approx(np.full(5, 3.0), abs=1e-6)


def test_a_wanted_speed_of_the_tool_becomes_its_straight_line():  # R-K05
    arm = ARMS["seven"]
    q = np.array([0.3, 0.5, -0.2, 0.9, 0.3, 0.6, 0.1])
    bench = bench_of("resolved", arm, frequency=250)
    bench["Q_MEZ"], bench["V_REF"] = q, np.zeros(6)
    bench.on()
    start = arm.pose(q)
    for _ in range(250):
        bench["V_REF"] = [0.0, 0.05, 0.0, 0.0, 0.0, 0.0]
        bench.cycle()
    moved = arm.pose(bench["Q_REF"])
    assert moved[:3, 3] - start[:3, 3] == pytest.approx([0.0, 0.05, 0.0], abs=1e-3)
    assert np.abs(moved[:3, :3] - start[:3, :3]).max() < 2e-3


def test_a_wanted_speed_from_before_the_last_hold_moves_nothing():  # law 3
    bench = bench_of("resolved", ARMS["six"], frequency=250)
    bench["Q_MEZ"], bench["V_REF"] = np.full(6, 0.4), np.full(6, 0.1)
    bench.forget("V_REF").on().cycle(100)
    assert bench["Q_REF"].tolist() == [0.4] * 6 and not bench["Q^_REF"].any()
    bench["V_REF"] = np.full(6, 0.05)
    assert bench.cycle()["Q^_REF"].any()


@pytest.mark.parametrize("name", sorted(ARMS))
def test_the_speed_of_the_tool_is_the_slope_of_its_place(name):
    arm = ARMS[name]
    q, qd = np.linspace(-0.2, 0.2, arm.n), np.linspace(1.0, -0.5, arm.n)
    bench = bench_of("fwdvel", arm)
    bench["Q_MEZ"], bench["Q^_MEZ"] = q, qd
    slope = (arm.pose(q + 1e-6 * qd)[:3, 3] - arm.pose(q - 1e-6 * qd)[:3, 3]) / 2e-6
    assert bench.on()["V_MEZ"][:3] == pytest.approx(slope, abs=1e-7)


def test_dexterity_is_lost_where_the_arm_is_stretched_or_at_a_limit():
    arm = ARMS["six"]
    bench = bench_of("dexterity", arm, frequency=50)
    bench["Q_MEZ"] = [0.4, 0.3, 0.9, 0.5, 1.1, 0.2]
    smallest, product, room = bench.on()["DEX"]
    model = ArmModel(*(arm.constants[key] for key in ("SCREW", "LINK", "PARENT")), None, None, arm.constants["TOOL"])
    determinant = np.linalg.det(model.jacobian([0.4, 0.3, 0.9, 0.5, 1.1, 0.2]))
    assert product == pytest.approx(abs(determinant)) and room == pytest.approx(2.6 - 1.1) and smallest > 0.02
    bench["Q_MEZ"] = [0.4, 0.3, 2.5999, 0.5, 1.1, 0.2]
    assert bench.cycle()["DEX"][2] == pytest.approx(1e-4, abs=1e-9)


def test_the_tool_gives_way_like_a_spring_and_bears_its_weight():  # R-K05
    arm = ARMS["seven"]
    q = np.array([0.3, 0.5, -0.2, 0.9, 0.3, 0.6, 0.1])
    simulated, bench = Simulated(arm, q), bench_of("impedance", arm, STIFF=500.0, JOINTS=2.0)
    bench["X_REF"], bench["Q_MEZ"] = arm.pose(q), q
    bench.on()
    jacobian, body = np.zeros((3, 7)), simulated.model.site_bodyid[0]
    for _ in range(4000):
        bench["Q_MEZ"], bench["Q^_MEZ"] = simulated.q, simulated.qd
        bench.cycle()
        mujoco.mj_jac(simulated.model, simulated.data, jacobian, None, simulated.tool.xpos, body)
        weight = simulated.data.qfrc_bias
        simulated.step(bench["TAU_PD"] + weight + jacobian.T @ [0.0, 5.0, 0.0])
    assert simulated.tool.xpos - arm.pose(q)[:3, 3] == pytest.approx([0.0, 0.01, 0.0], abs=5e-4)


def test_a_reference_far_away_pulls_no_harder_than_it_may():
    arm = ARMS["six"]
    q = np.array([0.4, 0.3, 0.9, 0.5, 1.1, 0.2])
    bench = bench_of("impedance", arm, MOST=10.0, TURN=0.0)
    far = arm.pose(q)
    far[0, 3] += 3.0
    bench["X_REF"], bench["Q_MEZ"] = far, q
    model = ArmModel(
        *(arm.constants[key] for key in ("SCREW", "LINK", "PARENT")), None, arm.constants["BASE"], arm.constants["TOOL"]
    )
    assert bench.on()["TAU_PD"] == pytest.approx(model.jacobian(q)[0] * 10.0)
    bench.off().forget("X_REF")
    assert not bench.on()["TAU_PD"].any()


def test_what_the_hand_holds_is_weighed_while_the_arm_is_nearly_still():  # R-K05
    arm = ARMS["seven"]
    tool = arm.constants["TOOL"]
    load = np.array([0.8, *(tool @ [0.0, 0.0, 0.03, 1.0])[:3]])
    laden = ArmModel(*(arm.constants[key] for key in ("SCREW", "LINK", "PARENT")), load, arm.constants["BASE"], tool)
    bench = bench_of("payload", arm, frequency=50).on()
    rest = np.zeros(7)
    assert bench["LOAD_MEZ"][0] == 0.0
    for q in np.random.default_rng(1).uniform(-1.2, 1.2, (40, 7)):
        bench["Q_MEZ"], bench["Q^_MEZ"], bench["TAU_MEZ"] = q, rest, laden.bias(q, rest)
        bench.cycle(5)
        bench["Q^_MEZ"], bench["TAU_MEZ"] = np.full(7, 0.5), np.full(7, 99.0)  # under way nothing is learnt
        bench.cycle(5)
    assert bench["LOAD_MEZ"] == pytest.approx(load, abs=0.01)


@pytest.mark.parametrize("name", sorted(ARMS))
def test_home_is_reached_whatever_robot_it_is_and_no_joint_is_too_fast(name):  # R-K05
    arm = ARMS[name]
    home, most = arm.constants["HOME"], arm.constants["Q^_MAX"]
    bench = bench_of("gohome", arm, frequency=250, SPEED=0.5)
    bench["Q_MEZ"] = start = np.clip(home - 0.4, arm.constants["QMIN"], arm.constants["QMAX"])
    bench.forget("Q_REF").on()
    assert bench["Q_REF"].tolist() == start.tolist()
    before, fastest = bench["Q_REF"], 0.0
    while bench.finished is None:
        bench.cycle()
        fastest = max(fastest, float((np.abs(bench["Q_REF"] - before) * 250 / most).max()))
        before = bench["Q_MEZ"] = bench["Q_REF"]
    assert bench["Q_REF"] == pytest.approx(home) and not bench["Q^_REF"].any()
    assert 0.45 < fastest <= 0.5 + 1e-6 and bench.get("progress") == 1.0


def test_who_is_at_home_is_done_at_once():
    arm = ARMS["five"]
    bench = bench_of("gohome", arm, frequency=250)
    bench["Q_MEZ"] = arm.constants["HOME"]
    assert bench.forget("Q_REF").on().cycle(3).finished is not None and bench.state is State.OFF


def test_friction_ahead_adds_what_the_links_take_at_the_wanted_speed():  # R-K05
    link = np.zeros((2, 13))
    link[:, 11], link[:, 12] = [2.0, 3.0], [0.5, 1.0]
    bench = Bench(MODULES / "friction.py", frequency=500, constants={"NDOF": 2, "LINK": link}).init()
    bench["TAU_IN"], bench["Q^_REF"] = [1.0, 1.0], [0.0, 10.0]
    assert bench.on()["TAU_OUT"] == pytest.approx([1.0, 1.0 + 30.0 + 0.8])
    bench["Q^_REF"] = [-10.0, float("nan")]
    assert bench.cycle()["TAU_OUT"] == pytest.approx([1.0 - 20.0 - 0.4, 1.0])


def test_the_observer_passes_over_what_is_no_number_and_sees_a_push():  # R-K05
    arm = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD)
    constants = {"NDOF": 6, "SCREW": arm.screw, "LINK": arm.link, "PARENT": arm.parent, "LOAD": arm.load}
    bench = Bench(MODULES / "observer.py", frequency=250, constants={**constants, "BASE": np.eye(4)}).init()
    bench["Q_MEZ"] = puma560.HOME
    bench["TAU_REF"] = arm.bias(puma560.HOME, np.zeros(6))
    bench.on().cycle(100)
    assert bench["TAU_EXT"] == pytest.approx(np.zeros(6), abs=1e-9)
    bench["TAU_REF"] = [float("nan")] * 6
    bench.cycle(10)
    bench["TAU_REF"] = arm.bias(puma560.HOME, np.zeros(6)) - np.array([0, 5.0, 0, 0, 0, 0])
    assert bench.cycle(200)["TAU_EXT"] == pytest.approx([0, 5.0, 0, 0, 0, 0], abs=0.01)
