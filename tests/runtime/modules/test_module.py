"""The module class."""

from types import SimpleNamespace

import pytest

from kit.labs.module_source import module
from kit.runtime.executive_rig import ExecutiveRig
from onika.model.lifecycle import State
from onika.module import Input, InVar, Local, Module, ModuleError, OutVar
from onika.ring.device import DeviceOrder, DriveState
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice


class Plain(Module):
    X = InVar("double", "m", "place")
    goal = Input("double", "m", "where")
    GAIN = Local("double", "-", "gain", default=2.0)


def test_declarations_are_collected_by_kind_in_order():  # R-A01
    assert list(Plain.declared_ports) == ["X"]
    assert list(Plain.declared_inputs) == ["goal"]
    assert list(Plain.declared_locals) == ["GAIN"]


def test_a_subclass_adds_to_its_own_declarations_only():  # R-A01
    class More(Plain):
        Y = OutVar("double")

    assert list(More.declared_ports) == ["X", "Y"]
    assert list(Plain.declared_ports) == ["X"]
    assert Module.declared_ports == {}


def test_user_input_is_handed_to_on_and_is_no_attribute():  # R-A10
    assert not hasattr(Plain, "goal")


def test_every_entry_point_may_be_left_out():  # R-A01
    plain = Plain()
    plain.init()
    plain.reinit()
    plain.on(SimpleNamespace())
    assert plain.cycle() is plain.sync() is None
    plain.off()
    plain.kill()
    plain.clear()


def test_reinit_is_init_unless_said_otherwise():  # R-A13
    calls = []
    cls = type("Counts", (Module,), {"init": lambda self: calls.append("init")})
    cls().reinit()
    assert calls == ["init"]


def test_hold_is_a_cycle_unless_said_otherwise():  # law 4
    calls = []
    cls = type("Counts", (Module,), {"cycle": lambda self: calls.append("cycle")})
    cls().hold()
    assert calls == ["cycle"]


def test_an_error_is_not_mended_unless_said_otherwise():  # R-A09
    assert Plain().error(ValueError()) is False


@pytest.mark.parametrize("ask", [lambda instance: instance.get("speed"), lambda instance: instance.set("speed", "1")])
def test_what_there_is_nothing_of_to_get_or_set_is_refused_by_name(ask):  # R-A05
    with pytest.raises(ModuleError, match="'speed'"):
        ask(Plain())


def test_warnings_are_texts():  # R-A07
    plain = Plain()
    plain.warn("slow")
    plain.warn(ValueError("hot"))
    assert [str(warning) for warning in plain.warnings] == ["slow", "hot"]


def test_a_reference_continues_while_it_is_in_force():  # law 3
    plain = Plain()
    assert not plain.continues("Q_REF")
    plain.in_force = frozenset({"Q_REF"})
    assert plain.continues("Q_REF")


def test_a_module_is_general_and_no_hardware_unless_it_says_so():  # R-A08, law 24
    assert (Module.trigger, Module.passive, Module.hardware, Module.crit) == (False, False, False, 0)


def test_a_robot_says_nothing_of_itself_and_reaches_everything_unless_it_knows_better():  # law 26
    assert Module.constants(SimpleNamespace(), {}) == {}
    assert Module.resolve({}, [("joint object", [1.0]), ("force object", [2.0])]) == [None, None]


def test_compiled_code_gets_the_memory_of_a_port():  # R-A01
    rig = ExecutiveRig().spawn("one", module("    X = InVar('double')\n    Y = OutVar('int[2]')"))
    running = rig.task("one").module
    running.buffer("Y")[:] = (3, 4)
    assert running.Y.tolist() == [3, 4]
    assert (running.buffer("X").shape, running.buffer("X").flags.writeable) == ((1,), False)
    with pytest.raises(AttributeError, match=r"expected a port \(X, Y\), found Z"):
        running.buffer("Z")


# Hardware modules

ARM = """
from onika.module import InVar, Local, Module, OutConst

class One(Module):
    hardware = True
    NDOF = OutConst("int")
    SIZE = OutConst("double", name="SIZE^")
    F = InVar("double")
    WIDE = Local("double", "m", "how wide", default=0.5)

    @classmethod
    def constants(cls, local, identity):
        return {"NDOF": 2, "SIZE^": 2 * local.WIDE}

    def init(self):
        assert self.state_constants() == {"NDOF": 2, "SIZE^": 2 * self.WIDE}

    def cycle(self):
        self.device.read()
        self.check_drive()
        self.device.write((self.F,))

    def clear(self):
        self.clear_drive()
"""


@pytest.fixture
def device():
    return BenchDevice((), ("force",))


@pytest.fixture
def arm(device, tmp_path):
    path = tmp_path / "one.py"
    path.write_text(ARM)
    bench = Bench(path, device=device).init().on()
    bench["F"] = 1.0
    return bench


def test_a_robot_publishes_what_it_states_before_a_run(arm):  # law 26
    assert (arm["NDOF"], arm["SIZE^"]) == (2, 1.0)


@pytest.mark.parametrize(
    ("drive", "why"), [(DriveState.TRIPPED, "the drive has tripped"), (DriveState.PRESSED, "panic button pressed")]
)
def test_a_drive_that_does_not_follow_is_an_error(arm, device, drive, why):  # law 17, R-K06
    device.values[1] = drive
    arm.cycle()
    assert (arm.state, why in arm.why) == (State.ERROR, True)


@pytest.mark.parametrize("drive", [DriveState.DRIVEN, DriveState.HELD])
def test_a_drive_that_holds_may_follow_again(arm, device, drive):  # law 4
    device.values[1] = drive
    assert arm.cycle().state is State.ON


def test_a_drive_is_cleared_only_after_its_button_was_let_go(arm, device):  # R-K06
    device.values[1] = DriveState.PRESSED
    arm.cycle().clear()
    assert (arm.state, "let it go, then clear" in arm.why) == (State.ERROR, True)
    device.values[1] = DriveState.TRIPPED
    device.publish(0)
    arm.clear()
    assert (arm.state, device.order) == (State.OFF, DeviceOrder.CLEAR)
