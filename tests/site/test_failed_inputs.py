"""What never reaches a drive in real processes: no number that is none, nothing that a failed task wrote."""

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.process.cli_process import CliProcess
from kit.process.failed_run import aborted, assert_held_in_time, failures

pytestmark = pytest.mark.site


@pytest.mark.parametrize("mode", [(), ("--virtual",)])
def test_no_number_that_is_none_reaches_a_drive_through_the_variables(tmp_path, mode):  # law 5
    laboratory = Laboratory(tmp_path)
    laboratory.module(
        "poison",
        "import numpy as np\n"
        "from onika.module import InConst, InVar, Module, OutVar\n"
        "class Poison(Module):\n"
        "    NDOF = InConst('int', '-', 'number of joints')\n"
        "    TAU_PD = InVar('double[NDOF]', 'N m', 'torque of the servo')\n"
        "    TAU_REF = OutVar('double[NDOF]', 'N m', 'wanted torque')\n"
        "    def init(self):\n"
        "        self._count = 0\n"
        "    def cycle(self):\n"
        "        self._count += 1\n"
        "        self.TAU_REF = self.TAU_PD * (1.0 if self._count < 100 else np.nan)\n",
    )
    laboratory.task(
        "poison",
        "MODULE poison\nDESC bad\nINCONST NDOF\nOUTCONST none\n"
        "INVAR TAU_PD\nOUTVAR TAU_REF\nTASKTYPE periodic\nFREQ 500",
    )
    laboratory.configuration("poisonC", "puma 500", "diff 500", "pd 500", "poison 500", "jtraj 250")
    path = laboratory.application(
        "poison", [job("poisonC", "Joint job"), joints("up", 0.0, -1.57, 1.57, 0.0, 0.0, 0.0)]
    )
    with CliProcess("run", str(path), "--json", *mode) as console:
        cause = aborted(console)["cause"]
    assert "puma is in error" in cause
    assert "NaN or infinity in TAU_REF" in cause
    assert_held_in_time(console)
    assert [event["cause"] for event in console.events if event["event"] == "drive"][1] == "commanded to hold"


@pytest.mark.parametrize("mode", [(), ("--virtual",)])
def test_an_arm_is_not_driven_on_with_what_a_failed_task_wrote_though_the_run_waits(tmp_path, mode):  # law 4, R-E08
    laboratory = Laboratory(tmp_path)
    laboratory.module(
        "relay",
        "from onika.module import InConst, InVar, Module, ModuleError, OutVar\n"
        "class Relay(Module):\n"
        "    NDOF = InConst('int', '-', 'number of joints')\n"
        "    TAU_PD = InVar('double[NDOF]', 'N m', 'torque of the servo')\n"
        "    TAU_REF = OutVar('double[NDOF]', 'N m', 'wanted torque')\n"
        "    def init(self):\n"
        "        self._count = 0\n"
        "    def cycle(self):\n"
        "        self._count += 1\n"
        "        if self._count == 100:\n"
        "            raise ModuleError('ill')\n"
        "        self.TAU_REF = self.TAU_PD\n",
    )
    laboratory.task(
        "relay",
        "MODULE relay\nDESC ill\nINCONST NDOF\nOUTCONST none\n"
        "INVAR TAU_PD\nOUTVAR TAU_REF\nTASKTYPE periodic\nFREQ 500",
    )
    laboratory.configuration("relayC", "puma 500", "diff 500", "pd 500", "relay 500", "jtraj 250")
    path = laboratory.application("relay", [job("relayC", "Joint job"), joints("up", 0.0, -1.57, 1.57, 0.0, 0.0, 0.0)])
    with CliProcess("run", str(path), "--json", "--on-error", "wait", *mode) as console:
        console.until(event="failed", task="puma")
        console.interrupt()
        aborted(console)
    failed = failures(console)
    assert "task relay, which wrote TAU_REF, is ERROR" in failed["puma"]["text"]
    assert failed["puma"]["at_s"] == failed["relay"]["at_s"]
    assert_held_in_time(console)
    assert [event["cause"] for event in console.events if event["event"] == "drive"][1] == "commanded to hold"


@pytest.mark.parametrize("mode", [(), ("--virtual",)])
def test_no_number_that_is_none_reaches_a_drive_through_its_device(tmp_path, mode):  # law 5
    laboratory = Laboratory(tmp_path)
    laboratory.module(
        "madhand",
        "from onika.module import InVar, Module, OutVar\n"
        "class Madhand(Module):\n"
        "    hardware = True\n"
        "    GRIP = InVar('double', '-', '+1 opens, -1 closes, 0 changes nothing')\n"
        "    GRIP_MEZ = OutVar('double[3]', 'm,m/s,N', 'opening, its speed, force on a finger')\n"
        "    def init(self):\n"
        "        self._count = 0\n"
        "    def cycle(self):\n"
        "        self._count += 1\n"
        "        self.GRIP_MEZ = self.device.read()\n"
        "        self.device.write((1.0 if self._count < 50 else float('nan'),))\n",
    )
    laboratory.plain_task("madhand", reads="GRIP", writes="GRIP_MEZ", hz=250, local="DEVICE boxes:gripper_left\n")
    laboratory.plain_task("opengrip", reads="GRIP_MEZ", writes="GRIP", hz=50, local="LEAST 9\nMOST 9\n")
    laboratory.configuration("madC", "madhand 250", "opengrip 50")
    with CliProcess("run", str(laboratory.application("mad", [job("madC")])), "--json", *mode) as console:
        cause = aborted(console)["cause"]
    assert "madhand is in error" in cause
    assert "finite commands" in cause
    causes = [event["cause"] for event in console.events if event["event"] == "drive"]
    assert "command is not finite" not in causes
    assert_held_in_time(console)
