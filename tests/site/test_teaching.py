import contextlib
import queue
import time

import numpy as np
import pytest

from kit.desk.dictionary_fixture import WHITE
from onika.desk.environment.environment import Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.initial_model import opened
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.desk.environment.stations import Stations
from onika.desk.environment.world_channel import WorldChannel
from onika.laws import puma560
from onika.laws.frames import pose_of_nine
from onika.laws.textbook import serial_arm
from onika.store.site import open_site
from onika.wire import act

pytestmark = pytest.mark.site

PATIENCE_S = 60.0


class Bench:
    """The environment with the shipped laboratories and a runtime of its own, in scaled time."""

    def __init__(self, folder):
        (folder / "home").mkdir()
        site = open_site([], {}, folder / "home")
        self.things = queue.Queue()
        self.station = Stations(
            RuntimeLauncher(("rt0",), is_virtual=True, options=("--scale", "4")), self.things.put, time.monotonic
        )
        model, _ = opened(site, None, {})
        self.environment = Environment(
            model, HANDLERS, Services(site, time.monotonic), WorldChannel(self.station, site)
        )
        self.station.begin(self.environment)

    def answer(self, wish):
        given = []
        self.environment.do(wish, "me", given.append)
        self.until(lambda: given)
        return given[0]

    def do(self, wish):
        answer = self.answer(wish)
        assert answer.no is None, answer.no
        return answer.value

    def until(self, reached):
        end = time.monotonic() + PATIENCE_S
        while not reached():
            assert time.monotonic() < end
            with contextlib.suppress(queue.Empty):
                self.things.get(timeout=0.05)()

    def item(self, kind):
        return self.environment.tree.types[kind].items[0]


@pytest.fixture
def bench(tmp_path):
    bench = Bench(tmp_path)
    yield bench
    bench.station.end()


def test_targets_are_taken_from_where_the_robot_stands(bench):  # R-D13, R-D23, R-K07, R-D08
    no = bench.answer(act.Teach("Cartesian object")).no
    assert "no robot is connected" in str(no.reason)
    doc = bench.do(act.Open("cmoveC"))
    bench.do(act.Connect(doc))
    bench.until(lambda: bench.item("Joint object").low is not None)
    assert np.allclose(bench.item("Joint object").low, puma560.QMIN)
    bench.until(lambda: "ctraj" in bench.environment.model.libraries.sheets)
    no = bench.answer(act.Teach("Cartesian object")).no
    bench.do(next(remedy.act for remedy in no.remedies if isinstance(remedy.act, act.Turn)))

    joints = bench.do(act.Teach("Joint object")).values["endpoint"]
    taught = bench.do(act.Teach("Cartesian object"))
    assert str(taught.source).startswith("X_MEZ, as fwdkin measures it in ")
    pose = pose_of_nine(list(taught.values["pose"]))
    assert np.allclose(pose[:3, :3] @ pose[:3, :3].T, np.eye(3)) and set(taught.values) == {"pose"}

    words = tuple(f"{joint:.6f}" for joint in joints)
    bench.do(act.MakeTarget("here", "Joint object", (words, ("2",)), WHITE))
    assert bench.environment.tree.onikons["here"].values[1] == ("2",)
    no = bench.answer(act.MakeTarget("beyond", "Joint object", (("9", *words[1:]), ("2",)), WHITE)).no
    assert "9 is above" in str(no.fields["endpoint[0]"])


def test_the_arm_of_the_open_program_is_measured_without_a_run_and_nothing_is_left(bench):  # R-D23
    doc = bench.do(act.NewApplication(1))
    job = bench.do(act.InsertIcon(doc, "jmoveC", "0", 0))
    taught = bench.do(act.Teach("Joint object", doc=doc, flow="0", after=job))
    assert (taught.arm, taught.arms, str(taught.source)) == ("puma", ("puma",), "where puma stands now")
    joints = taught.values["endpoint"]
    pose = pose_of_nine(list(bench.do(act.Teach("Cartesian object", doc=doc, after=job)).values["pose"]))
    arm = serial_arm(puma560.DH, base=np.eye(4), tool=puma560.TOOL)
    assert np.allclose(arm.forward(np.array(joints)), pose, atol=1e-3)
    assert bench.environment.model.measuring is None and "measuring" not in bench.environment.tree.runtime.subsystems
