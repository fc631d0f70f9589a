import pytest

from onika.host.loading.module_facts import ModuleFacts
from onika.store.shipped import shipped
from onika.wire.plan import Code
from onika.words.fault import Fault

ROBOT = """
import numpy as np
from onika.module import InVar, Local, Module, OutConst

class Robot(Module):
    \"\"\"A robot on a rail.\"\"\"

    hardware = True
    crit = 3
    N = OutConst("int", "-", "number of joints")
    QMAX = OutConst("double[N]", "m", "how far")
    Q_REF = InVar("double[N]", "m", "where to")
    REACH = Local("double", "m", "how far")

    @classmethod
    def constants(cls, local, identity):
        return {"N": np.int64(2), "QMAX": np.array([local.REACH, local.REACH]), "MORE": (np.float64(1.0), [2])}

    @classmethod
    def resolve(cls, constants, targets):
        return [None if max(values) <= constants["QMAX"][0] else "too far" for _, values in targets]
"""


def code(source, name="robot"):
    return Code("digest", name, f"/lab/module/{name}.py", source)


@pytest.fixture
def loading():
    return ModuleFacts()


def test_the_sheet_says_all_that_is_declared(loading):  # law 24
    sheet = loading.sheet(code(ROBOT))
    assert [(port.kind, port.name, port.shape) for port in sheet.ports] == [
        ("OUTCONST", "N", "int"),
        ("OUTCONST", "QMAX", "double[N]"),
        ("INVAR", "Q_REF", "double[N]"),
    ]
    assert (sheet.hardware, sheet.trigger, sheet.passive, sheet.crit) == (True, False, False, 3)
    assert sheet.doc == "A robot on a rail."


def test_constants_come_from_the_local_lines_as_plain_values(loading):  # law 26
    constants = loading.constants(code(ROBOT), (("REACH", ("0.5",)), ("DEVICE", ("rail:r",))))
    assert constants == {"N": 2, "QMAX": [0.5, 0.5], "MORE": [1.0, [2]]}
    assert type(constants["N"]) is int


def test_the_reach_of_every_target_is_answered(loading):  # R-X02, law 26
    targets = [("joint object", [0.1, 0.2]), ("joint object", [0.1, 0.9])]
    near, far = loading.resolve(code(ROBOT), {"QMAX": [0.5, 0.5]}, targets)
    assert (near, str(far)) == (None, "too far")


def test_the_shipped_robot_knows_its_reach(loading):  # R-K01, R-X02
    path = shipped() / "generic" / "module" / "arm.py"
    robot = Code("digest", "arm", str(path), path.read_text())
    constants = loading.constants(robot, (("ROBOT", ("puma560",)), ("BASE", ("0", "0", "0", "0"))))
    assert constants["NDOF"] == 6
    targets = [("joint object", [0.0, -1.5, 1.5, 0.0, 0.0, 0.0]), ("joint object", [9.0, -1.5, 1.5, 0.0, 0.0, 0.0])]
    near, far = loading.resolve(robot, constants, targets)
    assert near is None
    assert (far.key, far.args["joint"]) == ("laws.joint_value_beyond", 1)


@pytest.mark.parametrize(
    ("source", "line", "key"),
    [
        ("class Bad(:\n", 1, "runtime.not_python"),
        ("x = 1\n", 0, "runtime.no_module_class"),
        ("import nothing_like_it\n", 1, "runtime.unimportable"),
        ("\n\nraise ValueError('no')\n", 3, "runtime.unimportable"),
        (
            "from onika.module import Module\nclass A(Module): trigger = passive = True\n",
            0,
            "host.declarations_disagree",
        ),
        (
            "from onika.module import Module\nclass A(Module): pass\nclass B(Module): pass\n",
            0,
            "runtime.one_module_class",
        ),
    ],
)
def test_code_that_cannot_be_used_is_a_fault_with_its_line(loading, source, line, key):  # R-B07, law 21
    for fault in (
        loading.sheet(code(source)),
        *(() if "passive" in source else (loading.constants(code(source), ()), loading.resolve(code(source), {}, []))),
    ):
        assert isinstance(fault, Fault)
        assert (fault.place.file, fault.place.line) == ("/lab/module/robot.py", line)
        assert fault.reason.key == key


@pytest.mark.parametrize("entry", ["constants", "resolve"])
def test_what_raises_while_it_is_asked_is_a_fault_with_its_line(loading, entry):  # R-B07
    head = "from onika.module import Module\nclass A(Module):\n    @classmethod\n"
    source = head + f"    def {entry}(cls, *_):\n        1 / 0\n"
    fault = loading.constants(code(source), ()) if entry == "constants" else loading.resolve(code(source), {}, [])
    assert fault.place.line == 5
    assert "ZeroDivisionError" in str(fault.reason)


def test_a_missing_local_line_is_a_fault(loading):  # R-B07
    assert str(loading.constants(code(ROBOT), ()).reason) == (
        "expected constants from the LOCAL lines"
        ", found ValueError: expected a LOCAL line REACH double (how far), found none"
    )
