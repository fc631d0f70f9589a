"""Programs with something planted in them, sound ones too, and what is to be said of each before it runs."""

import math
import re
from collections.abc import Callable, Collection, Sequence
from pathlib import Path

from kit.labs.laboratory import Laboratory, job, joints, target
from onika.store.shipped import shipped

LEANS, FAR = "the hand would lean", "the wrist would be"
MODES, ONE_DEVICE = "all arms of a world are of one mode", "claims it too"
HOME, ASIDE = "jmoveC home", "jmoveC aside"
NOT_THERE = "expected a task of"

MakeProgram = Callable[[Path], Path]
"""Writes a program into a base directory; its file."""

REACHED, BEYOND = (0.2, -0.6, 2.7, 0.0, 1.0, 0.0), (0.2, -0.6, 9.0, 0.0, 1.0, 0.0)
FOUR = (0.0, 0.9, 0.05, -0.8)
POSE, FURTHER = "0 0 -1 0 1 0 0.7 0.2 -0.3", "0 0 -1 0 1 0 0.9 0.1 -0.2"


def moved(*targets: str) -> list[str]:
    """An arm moved to each target."""
    return [step for aim in targets for step in (job("jmoveC", "Joint job"), aim)]


def lined(*poses: str) -> list[str]:
    """A tool led along a straight line to each pose."""
    kind = "Cartesian"
    return [
        step
        for k, pose in enumerate(poses)
        for step in (job("cmoveC", f"{kind} job"), target(f"p{k}", f"{kind} object", pose, "1.0"))
    ]


def rmod(name: str, **changes: str | None) -> str:
    """A shipped task as text, with lines of it changed: `DEVICE="boxes:arm_right"`; None leaves a line out."""
    text = next(shipped().glob(f"*/module/{name}.rmod")).read_text(encoding="utf-8").partition("EOF")[0]
    for key, words in changes.items():
        line = "" if words is None else f"{key:<12}{words}\n"
        text, count = re.subn(rf"(?m)^{re.escape(key)} .*\n", line, text)
        assert count == 1
    return text


def without(configuration: str, task: str) -> list[str]:
    """A shipped configuration as the tasks in it, without one."""
    text = next(shipped().glob(f"*/conf/{configuration}.conf")).read_text(encoding="utf-8")
    rates = re.findall(r"RMODFILE +(\S+)\n.*\n.*\nFREQ +(\S+)", text)
    return [f"{name} {rate}" for name, rate in rates if name != task]


def own(name: str, steps: Sequence[str], **tasks: dict[str, str | None]) -> MakeProgram:
    """A laboratory with a program, and shipped tasks as they were changed."""

    def make(path: Path) -> Path:
        lab = Laboratory(path)
        for task, changes in tasks.items():
            lab.task(task, rmod(str(changes.pop("of", task)), **changes))
        return lab.application(name, steps)

    return make


def lacking(configuration: str, task: str, kind: str, *icons: str) -> MakeProgram:
    """A program whose job lacks a task."""

    def make(path: Path) -> Path:
        lab = Laboratory(path)
        lab.configuration("lameC", *without(configuration, task))
        return lab.application("lame", [job("lameC", kind), *icons])

    return make


def nested(inner: Sequence[str], *steps: str) -> MakeProgram:
    """A program with another one in it, which comes first."""

    def make(path: Path) -> Path:
        lab = Laboratory(path)
        lab.application("inner", inner)
        return lab.application("p", [job("inner", "Complete application"), *steps])

    return make


def asking(condition: str, *steps: str) -> MakeProgram:
    """A program that goes round as long as a condition holds."""

    def make(path: Path) -> Path:
        marks = ("WHILETAG    again", "WHILETEST   yes", f"WHILEIF     {condition}")
        begins = job("opengripC", "Complete job", "WHILETAG    again", "WHILETEST   no")
        written = Laboratory(path).application("p", [begins, *steps, job("closegripC", "Complete job", *marks)])
        written.write_text(written.read_text(encoding="utf-8").replace("VERSION     1.3", "VERSION     2.0"))
        return written

    return make


PLANTED: dict[str, tuple[MakeProgram, tuple[str, ...], Collection[str]]] = {
    # reach, limits
    "joint 3 beyond": (own("p", moved(joints("far", *BEYOND))), (), ["far: joint 3 at 9.00 rad is beyond"]),
    "two of three beyond": (
        own("p", moved(joints("a", *BEYOND), joints("b", *REACHED), joints("c", 9.0, *REACHED[1:]))),
        (),
        ["a: joint 3", "c: joint 1"],
    ),
    "beyond for both": (own("p", moved(joints("far", *BEYOND))), ("puma=puma_kin",), ["far: "]),
    "a duration that is none": (
        own("p", moved(joints("slow", *REACHED, duration=900.0))),
        (),
        ["slow: duration: expected 0.1..600 s"],
    ),
    "pose out of reach": (own("p", lined("0 0 -1 0 1 0 1.9 0.2 -0.3")), (), ["p0: out of reach"]),
    "pose that is none": (own("p", lined("0 0 -1 0 0 1 0.7 0.2 -0.3")), (), ["p0: "]),
    "pose beyond the scara": (
        own("p", lined(POSE, "0 0 -1 0 1 0 0.9 0.1 -0.2")),
        ("puma=scara",),
        ["p1: out of reach"],
    ),
    "pose leaning for the scara": (own("p", lined("1 0 0 0 1 0 0.6 0.2 -0.2")), ("puma=scara",), ["p0: "]),
    "pose above the scara": (own("p", lined("0 0 -1 0 1 0 0.6 0.2 0.6")), ("puma=scara",), ["p0: "]),
    # devices, sensors
    "no such device": (
        own("p", lined(POSE), puma={"DEVICE": "boxes:arm_middle"}),
        (),
        ["DEVICE boxes:arm_middle"],
    ),
    "no such world": (own("p", lined(POSE), puma={"DEVICE": "shed:arm_left"}), (), ["found DEVICE shed:arm_left"]),
    "another robot behind": (
        own("p", lined(POSE), puma={"DEVICE": "boxes:scara_left"}),
        (),
        ["expected the robot puma560 behind the device"],
    ),
    "forces behind none": (
        own("p", lined(POSE), puma_kin={"DEVICE": "boxes:arm_left"}),
        ("puma=puma_kin",),
        ["expected a device that is driven by posture, found one driven by torque"],
    ),
    "elsewhere": (own("p", lined(POSE), puma={"BASE": "0.1 0 0 0"}), (), ["expected frame 0 of the robot at"]),
    "no sensor": (own("p", lined(POSE), led_monitor={"DEVICE": "boxes:bulb"}), (), ["found DEVICE boxes:bulb"]),
    "no device said": (own("p", lined(POSE), puma={"DEVICE": None}), (), ["a LOCAL line DEVICE"]),
    # ports, numbers of joints, rates
    "no robot in a job": (
        lacking("jmoveC", "puma", "Joint job", joints("there", *REACHED)),
        (),
        tuple(
            f"the constant {name}"
            for name in ("NDOF", "SCREW", "LINK", "PARENT", "LOAD", "BASE", "QMIN", "QMAX", "Q^_MAX", "KP", "KD")
        ),
    ),
    "no trigger": (lacking("jmoveC", "jtraj", "Complete job"), (), ["a trigger that ends job lameC"]),
    "a port too many": (own("p", lined(POSE), pd={"INVAR": "Q_REF Q^_REF Q_MEZ Q^_MEZ ODD"}), (), ["INVAR ODD"]),
    "a port too few": (own("p", lined(POSE), pd={"INVAR": "Q_REF Q^_REF Q_MEZ"}), (), ["INVAR Q^_MEZ"]),
    "too slow a robot": (own("p", lined(POSE), puma={"FREQ": "20"}), (), ["at least 40 Hz"]),
    "a parameter that is none": (own("p", lined(POSE), puma={"BASE": "0 0"}), (), ["LOCAL BASE"]),
    "a parameter beyond what is possible": (
        own("p", lined(POSE), puma={"BASE": "0 0 0 0\nSTEP        -5"}),
        (),
        ["STEP"],
    ),
    "five of six joints": (
        own("p", [job("jmove_scaraC", "Joint job"), joints("there", *REACHED)]),
        (),
        ["expected 5 values (endpoint[4], duration[1]), found 7"],
    ),
    "four of six joints": (
        own("p", moved(joints("few", 0.1, 0.2, 0.1, 0.0))),
        (),
        ["expected 7 values (endpoint[6], duration[1]), found 5"],
    ),
    "nobody writes what it follows": (
        lacking("cmoveC", "invkin", "Cartesian job", target("p", "Cartesian object", POSE, "1.0")),
        ("puma=puma_kin",),
        ["`puma_kin` reads Q_REF, which no task of `lameC` writes"],
    ),
    # another device than is meant
    "a lamp on an arm": (
        own("p", lined(POSE), led_monitor={"DEVICE": "boxes:arm_right"}),
        (),
        ["expected the lamp behind the device, found puma560"],
    ),
    "a hand on an arm": (
        own("p", [job("opengripC")], gripper={"DEVICE": "boxes:arm_left"}),
        (),
        ["expected a hand behind the device, found puma560"],
    ),
    "a robot on the lamp": (
        own("p", lined(POSE), puma={"DEVICE": "boxes:lamp"}),
        (),
        ["every device claimed once", "expected the robot puma560 behind the device, found another device"],
    ),
    "a device without a name": (own("p", lined(POSE), puma={"DEVICE": ""}), (), ["one device after LOCAL DEVICE"]),
    "two devices": (
        own("p", lined(POSE), puma={"DEVICE": "boxes:arm_left boxes:arm_right"}),
        (),
        ["one device after LOCAL DEVICE, as world:device, found boxes:arm_left boxes:arm_right"],
    ),
    "no device of that world": (own("p", lined(POSE), puma={"DEVICE": "boxes:"}), (), ["found DEVICE boxes:"]),
    # values that another robot would take for others, limits by a hair
    "five joints for a scara": (
        own("p", moved(joints("few", 0.1, 0.2, 0.1, 0.0, 0.1))),
        ("puma=scara",),
        ["expected values for puma, found few: expected 7 values (endpoint[6], duration[1]), found 6"],
    ),
    "seven joints for a scara": (
        own("p", moved(joints("many", 0.1, 0.2, 0.1, 0.0, 0.1, 0.2, 0.3))),
        ("puma=scara",),
        ["expected values for puma, found many: expected 7 values"],
    ),
    "beyond by a hair": (
        own("p", moved(joints("far", 2.7926, *REACHED[1:]))),
        (),
        ["far: joint 1 at 2.7926 rad is beyond 2.7925"],
    ),
    "a duration by a hair": (
        own("p", moved(joints("slow", *REACHED, duration=600.0001))),
        (),
        ["expected 0.1..600 s, found 600.0001"],
    ),
    "a speed of nothing": (
        own("p", moved(joints("there", *REACHED)), jtraj={"SPEED": "0"}),
        (),
        ["LOCAL SPEED: expected 0.01..1 -, found 0"],
    ),
    "a speed backwards": (
        own("p", moved(joints("there", *REACHED)), jtraj={"SPEED": "-0.6"}),
        (),
        ["LOCAL SPEED: expected 0.01..1 -, found -0.6"],
    ),
    # what is nested, what is asked, what two flows want
    "nested, beyond the scara": (
        nested(lined("0 0 -1 0 1 0 0.9 0.1 -0.2"), *lined(POSE)),
        ("puma=scara",),
        ["action 1 of inner: cmoveC p0"],
    ),
    "a joint that the scara lacks": (
        asking("Q_MEZ[5] > 1", *lined(POSE)),
        ("puma=scara",),
        ["one number of Q_MEZ, which is double[4]"],
    ),
    "sound for a joint that the puma has": (asking("Q_MEZ[5] > 1", *lined(POSE)), ("puma=puma_kin",), []),
    "sound, nested": (nested(lined(POSE), *lined(POSE)), ("puma=scara",), []),
    "sound at a limit": (own("p", moved(joints("edge", math.radians(160.0), *REACHED[1:]))), (), []),
    # sound ones
    "sound for four joints": (own("p", [job("jmove_scaraC", "Joint job"), joints("there", *FOUR)]), (), []),
    "sound for six in place of four": (
        own("p", [job("jmove_scaraC", "Joint job"), joints("there", *FOUR)]),
        ("scara=puma",),
        [],
    ),
    "sound": (own("p", moved(joints("there", *REACHED))), (), []),
    "sound lines": (own("p", lined(POSE)), (), []),
    "sound for the mode": (own("p", moved(joints("there", *REACHED))), ("puma=puma_kin",), []),
    "sound for the scara": (own("p", lined(POSE)), ("puma=scara",), []),
    "sound for the scara's mode": (own("p", lined(POSE)), ("0:puma=scara_kin",), []),
    "sound at the right": (own("p", lined("0 0 -1 0 1 0 0.7 0.2 -0.3")), ("puma=puma_right",), []),
    "sound with another name": (own("p", lined(POSE), twin={"of": "puma"}), ("puma=twin",), []),
}
