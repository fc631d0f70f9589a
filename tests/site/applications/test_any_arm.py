"""An arm of seven joints that is nothing but files: the generic tasks move it, whatever its drives take (K03, X19)."""

import numpy as np
import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
from kit.worlds.file_cells import CELL
from kit.worlds.mjcf_arms import SEVEN, mjcf_arm
from onika.cli import main
from onika.laws.frames import nine_of_pose

pytestmark = pytest.mark.site

MOTORS = "".join(f'<motor name="m{k}" joint="joint{k}" ctrlrange="-150 150"/>' for k in range(1, 8))
HOME = (0.3, 0.5, -0.2, 0.9, 0.3, 0.6, 0.1)
ROBOT = f"""VERSION 2.0
FILE seven.xml
ARM arm
TOOL tool
FROM base
DRIVE {{drive}}
HOME {" ".join(map(str, HOME))}
EOF
"""
WORLD = """VERSION 2.0
PLACE -
ROBOTS seven
AT 0 0 0 0
EOF
"""
CONSTANTS = "NDOF SCREW LINK PARENT LOAD QMIN QMAX Q^_MAX TAUMAX BASE TOOL HOME ROBOT"
MODULES = {
    "position": ("arm_pos", "Q_REF Q^_REF"),
    "torque": ("arm_tau", "TAU_REF"),
    "velocity": ("arm_vel", "Q^_REF"),
}
CONTROL = {"position": (), "torque": ("comptorque 500",), "velocity": ()}
WATCH = ("fwdvel 250", "dexterity 50", "payload 50")

PUSH = """
from onika.module import Module, OutVar, finish

class Push(Module):
    trigger = True

    V_REF = OutVar("double[6]", "m/s,rad/s", "wanted speed of the tool and of its turning, in the world")

    def on(self, inputs):
        self._time = 0.0

    def cycle(self):
        self._time += self.dt
        self.V_REF = [0.0, 0.04 if self._time < 1.0 else 0.0, 0.0, 0.0, 0.0, 0.0]
        return finish() if self._time > 1.2 else None
"""


def numbered(text):
    """The model with names for its joints, and a motor at each."""
    for k in range(1, 8):
        text = text.replace("<joint axis", f'<joint name="joint{k}" axis', 1)
    return text.replace("</worldbody>", f"</worldbody><actuator>{MOTORS}</actuator>")


@pytest.fixture(params=sorted(MODULES))
def lab(request, tmp_path):
    return laboratory(tmp_path, request.param)


def laboratory(tmp_path, drive):
    """A base directory with the arm, its world and its jobs."""
    lab, (module, reads) = Laboratory(tmp_path / "seven"), MODULES[drive]
    for folder, name, text in (
        ("robot", "seven.xml", numbered(SEVEN)),
        ("robot", "seven.robot", ROBOT.format(drive=drive)),
        ("world", "hall.world", WORLD),
    ):
        (lab.path / folder).mkdir(parents=True, exist_ok=True)
        (lab.path / folder / name).write_text(text)
    lab.task(
        "seven",
        f"MODULE      {module}\nDESC        the arm of seven joints\nINCONST     none\nOUTCONST    {CONSTANTS}\n"
        f"INVAR       {reads}\nOUTVAR      Q_MEZ Q^_MEZ TAU_MEZ\nTASKTYPE    periodic\nFREQ        500\n\n"
        "LOCAL\nDEVICE      hall:seven",
    )
    lab.configuration("jmove_sevenC", "seven 500", *CONTROL[drive], *WATCH, "jtraj 250")
    lab.configuration("cmove_sevenC", "seven 500", *CONTROL[drive], "fwdkin 250", "invkin 250", "ctraj 250")
    lab.configuration("home_sevenC", "seven 500", *CONTROL[drive], "gohome 250")
    return lab


def run(lab, name, *options):
    return main(["run", str(lab.path / "appl" / f"{name}.appl"), "--virtual", *options])


def expect(lab, name, *conditions):
    """Run it, and ask for these at its end."""
    return run(lab, name, *(word for condition in conditions for word in ("--expect", condition)))


def place(name, pose, duration=2.0):
    return target(name, "Cartesian object", " ".join(map(str, nine_of_pose(pose))), str(duration))


def test_it_moves_its_joints_and_its_tool_and_goes_home(lab, capsys):  # R-X19, R-K03
    arm = mjcf_arm(SEVEN)
    start = np.add(HOME, (0.2, -0.1, 0.1, 0.2, -0.1, 0.1, 0.3))
    beside = arm.pose(start)
    beside[:3, 3] += 0.03, -0.04, -0.03
    joint, straight = job("jmove_sevenC", "Joint job"), job("cmove_sevenC", "Cartesian job")
    lab.application(
        "tour", [joint, joints("there", *start, duration=2.0), straight, place("beside", beside), job("home_sevenC")]
    )
    near = [f"Q_MEZ[{k}] >= {angle - 0.002}" for k, angle in enumerate(HOME)]
    near += [f"Q_MEZ[{k}] <= {angle + 0.002}" for k, angle in enumerate(HOME)]
    watched = ["DEX[0] >= 0.001", "DEX[2] <= 2.6", "LOAD_MEZ[0] <= 0.1", "LOAD_MEZ[0] >= -0.1"]
    assert expect(lab, "tour", *near, *watched) == 0, capsys.readouterr()


def test_its_tool_gives_way_like_a_spring_on_a_straight_line(tmp_path, capsys):  # R-K05
    lab = laboratory(tmp_path, "torque")
    lab.configuration(
        "softC", "seven 500", "fwdkin 250", "gravcomp 500", "impedance 500", "torque_sum 500", "ctraj 250"
    )
    beside = mjcf_arm(SEVEN).pose(np.array(HOME))
    beside[:3, 3] += 0.02, -0.03, 0.0
    lab.application("soft", [job("softC", "Cartesian job"), place("beside", beside)])
    x, y = beside[0, 3], beside[1, 3]
    near = [f"X_MEZ[0,3] >= {x - 0.01}", f"X_MEZ[0,3] <= {x + 0.01}", f"X_MEZ[1,3] >= {y - 0.01}"]
    assert expect(lab, "soft", *near, f"X_MEZ[1,3] <= {y + 0.01}") == 0, capsys.readouterr()


def test_its_tool_goes_as_fast_as_is_wanted(tmp_path, capsys):  # R-K05
    lab = laboratory(tmp_path, "position")
    lab.module("push", PUSH)
    lab.plain_task("push", writes="V_REF")
    lab.configuration("pushC", "seven 500", "fwdkin 250", "resolved 250", "push 100")
    lab.application("pushed", [job("pushC")])
    y = mjcf_arm(SEVEN).pose(np.array(HOME))[1, 3] + 0.04
    assert expect(lab, "pushed", f"X_MEZ[1,3] >= {y - 0.002}", f"X_MEZ[1,3] <= {y + 0.002}") == 0, capsys.readouterr()


def test_what_it_cannot_reach_is_refused_before_anything_moves(lab, capsys):  # R-E09, law 26
    far = mjcf_arm(SEVEN).pose(np.array(HOME))
    far[0, 3] += 3.0
    bent = joints("bent", 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 9.0)
    lab.application(
        "far", [job("jmove_sevenC", "Joint job"), bent, job("cmove_sevenC", "Cartesian job"), place("far", far)]
    )
    assert run(lab, "far") != 0
    told = "".join(capsys.readouterr())
    assert "joint 7 at 9.00 rad is beyond 2.60" in told
    assert "out of reach: the nearest posture found within limits" in told
    assert "refused, nothing moved" in told


@pytest.mark.parametrize(("opening", "low", "high"), [("0.05", 0.049, 0.051), ("0.01", 0.009, 0.011)])
def test_a_gripper_that_is_nothing_but_files_opens_and_closes_as_far_as_is_wanted(
    tmp_path, opening, low, high
):  # R-X19
    lab = Laboratory(tmp_path / "hand")
    for name, text in CELL.items():
        path = lab.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    lab.task(
        "hand",
        "MODULE      grip\nDESC        the hand\nINCONST     none\nOUTCONST    none\nINVAR       OPEN_REF FORCE_REF\n"
        "OUTVAR      GRIP_MEZ\nTASKTYPE    periodic\nFREQ        250\n\nLOCAL\nDEVICE      cell:elbow_gripper_left",
    )
    lab.configuration("handC", "hand 250", "squeeze 50")
    lab.application("grasp", [job("handC", "Gripper job"), target("so_far", "Gripper object", opening, "15.0")])
    assert run(lab, "grasp", "--expect", f"GRIP_MEZ[0] >= {low}", "--expect", f"GRIP_MEZ[0] <= {high}") == 0


def test_the_tasks_that_know_no_robot_have_a_workshop_to_be_tried_in(tmp_path, capsys):  # R-X19
    lab, there = Laboratory(tmp_path / "own"), joints("there", 0.3, 0.6, 1.0, 0.2, 0.8, 0.1, duration=2.0)
    lab.configuration("jmove_posC", "arm_pos 500", "jtraj 250")
    lab.configuration("jmove_tauC", "arm_tau 500", "comptorque 500", "jtraj 250")
    lab.configuration("gripC", "grip 250", "fingers 50")
    lab.configuration("liftC", "axes 500", "jtraj 250")
    wide, high = target("wide", "Level object", "0.06"), joints("high", 0.15, 1.0, duration=2.0)
    lab.application("position", [job("jmove_posC", "Joint job"), there, job("gripC", "Level job"), wide])
    lab.application("torque", [job("jmove_tauC", "Joint job"), there])
    lab.application("rise", [job("liftC", "Joint job"), high])
    near = [f"Q_MEZ[{k}] >= {angle - 0.005}" for k, angle in enumerate((0.3, 0.6, 1.0, 0.2, 0.8, 0.1))]
    assert expect(lab, "position", *near, "GRIP_MEZ[0] >= 0.05") == 0, capsys.readouterr()
    assert expect(lab, "torque", *near) == 0, capsys.readouterr()
    assert expect(lab, "rise", "Q_MEZ[0] >= 0.145", "Q_MEZ[1] >= 0.99") == 0, capsys.readouterr()
