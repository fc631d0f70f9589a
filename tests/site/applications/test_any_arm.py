"""An arm of seven joints that is nothing but files: the generic tasks move it, whatever its drives take (K03, X19)."""

import numpy as np
import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
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
MODULES = {"position": ("arm_pos", "Q_REF Q^_REF"), "torque": ("arm_tau", "TAU_REF")}
CONTROL = {"position": (), "torque": ("comptorque 500",)}


def numbered(text):
    """The model with names for its joints, and a motor at each."""
    for k in range(1, 8):
        text = text.replace("<joint axis", f'<joint name="joint{k}" axis', 1)
    return text.replace("</worldbody>", f"</worldbody><actuator>{MOTORS}</actuator>")


@pytest.fixture(params=sorted(MODULES))
def lab(request, tmp_path):
    drive = request.param
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
    lab.configuration("jmove_sevenC", "seven 500", *CONTROL[drive], "jtraj 250")
    lab.configuration("cmove_sevenC", "seven 500", *CONTROL[drive], "fwdkin 250", "invkin 250", "ctraj 250")
    lab.configuration("home_sevenC", "seven 500", *CONTROL[drive], "gohome 250")
    return lab


def run(lab, name, *options):
    return main(["run", str(lab.path / "appl" / f"{name}.appl"), "--virtual", *options])


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
    code = run(lab, "tour", *(word for condition in near for word in ("--expect", condition)))
    assert code == 0, capsys.readouterr()


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
