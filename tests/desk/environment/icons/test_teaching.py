from dataclasses import replace

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.initial_model import opened
from onika.desk.environment.outcome.outcome import Done
from onika.model.task import Task
from onika.store.site import open_site
from onika.wire import act, live, request
from onika.wire.sheet import InputSheet, ModuleSheet, PortSheet
from onika.words.reason import Reason

SITE_MODEL, _ = opened(open_site([], {}, None), None, {})
ARM = Task("arm", "arm", outvar=("Q_MEZ",), invar=("Q_REF",), frequency=100.0)
EYE = Task("eye", "eye", invar=("Q_MEZ",), outvar=("X_MEZ",), frequency=100.0)
MOVE = Task("move", "move", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0, object_type="Joint job")
SLIDE = Task("slide", "slide", invar=("X_MEZ",), outvar=("X_REF",), frequency=100.0, object_type="Cartesian job")
NAP = Task("nap", "nap", frequency=100.0, object_type="Pause job")


def sheet(ports=(), inputs=(), hardware=False):
    return ModuleSheet(ports, inputs, (), bool(inputs), False, hardware, 0, "")


TIME = InputSheet("duration", "double", "s", "", 0.1, 600.0, None)
JOINTS = PortSheet("INVAR", "Q_MEZ", "double[NDOF]", "rad", "")
FRAME = PortSheet("INVAR", "X_MEZ", "double[4,4]", "-", "")
SHEETS = {
    "arm": sheet(hardware=True),
    "eye": sheet((JOINTS,)),
    "move": sheet((JOINTS,), (InputSheet("endpoint", "double[NDOF]", "rad", "", "QMIN", "QMAX", None), TIME)),
    "slide": sheet((FRAME,), (InputSheet("pose", "double[9]", "-", "", None, None, None), TIME)),
    "nap": sheet((), (TIME,)),
}
POSE = [[1.0, 0.0, 0.0, 0.5], [0.0, -1.0, 0.0, 0.6], [0.0, 0.0, -1.0, 0.7], [0.0, 0.0, 0.0, 1.0]]


class Reader(LiveRuntime):
    def ask(self, wish):
        if isinstance(wish, live.Describe):
            return live.Described({code.digest: SHEETS[code.module] for code in wish.code})
        return super().ask(wish)


@pytest.fixture
def duet(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, (ARM, EYE, MOVE, SLIDE, NAP), Reader())
    duet.environment.become(lambda model: Done(replace(model, syntax=SITE_MODEL.syntax, sources=SITE_MODEL.sources)))
    return duet


def measuring(duet, *tasks):
    doc = duet.connected(*tasks)
    home = duet.document(doc).live.subsystem
    duet.runtime.variables[home] = {"Q_MEZ": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], "X_MEZ": POSE}
    return doc, home


def test_joint_angles_are_taken_from_the_arm_as_it_stands_and_the_duration_is_left_to_the_user(duet):  # R-D13, R-D23
    doc, home = measuring(duet, "arm", "move")
    duet.do(act.Turn(doc, ("arm",), True))
    taught = duet.do(act.Teach("Joint object"))
    assert taught.values == {"endpoint": (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)}
    assert (str(taught.source), taught.subsystem, taught.others) == (f"Q_MEZ, as arm measures it in {home}", home, ())


def test_a_frame_is_given_as_the_nine_numbers_of_a_target(duet):  # R-D13, reading 44
    doc, _ = measuring(duet, "arm", "eye")
    duet.do(act.Turn(doc, ("arm", "eye"), True))
    taught = duet.do(act.Teach("Cartesian object"))
    assert taught.values == {"pose": (0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.5, 0.6, 0.7)}


def test_what_does_not_run_measures_nothing_and_could_be_turned_on(duet):  # R-D13, R-X01
    doc, _ = measuring(duet, "arm", "eye")
    no = duet.no(act.Teach("Cartesian object"))
    assert str(no.reason) == "nothing that runs measures X_MEZ now"
    assert (str(no.remedies[0].label), no.remedies[0].act) == (
        "Turn arm and eye ON",
        act.Turn(doc, ("arm", "eye"), True),
    )
    duet.do(no.remedies[0].act)
    assert duet.do(act.Teach("Cartesian object")).values["pose"]


def test_where_no_robot_is_connected_a_configuration_could_be(duet):  # R-X01
    doc = duet.new("arm")
    duet.environment.become(lambda model: Done(replace(model, libraries=replace(model.libraries, sheets=SHEETS))))
    no = duet.no(act.Teach("Joint object"))
    assert "no robot is connected" in str(no.reason)
    assert [remedy.act for remedy in no.remedies][:1] == [act.Connect(doc)]
    duet.do(no.remedies[0].act)


def test_of_several_arms_the_one_that_is_named_is_asked(duet):  # R-K07
    left, home = measuring(duet, "arm")
    duet.do(act.Turn(left, ("arm",), True))
    right = duet.new("arm")
    duet.do(act.Connect(right, subsystem="right"))
    duet.runtime.variables["right"] = {"Q_MEZ": [6.0] * 6}
    duet.do(act.Turn(right, ("arm",), True))
    taught = duet.do(act.Teach("Joint object"))
    assert (taught.subsystem, taught.others) == (home, ("right",))
    assert duet.do(act.Teach("Joint object", "right")).values["endpoint"] == (6.0,) * 6
    assert "nothing in far" in str(duet.no(act.Teach("Joint object", "far")).reason)


def test_a_robot_of_other_joints_gives_as_many_values_as_it_has(duet):  # R-D13
    doc, home = measuring(duet, "arm")
    duet.runtime.variables[home] = {"Q_MEZ": [0.1, 0.2, 0.3, 0.4]}
    duet.do(act.Turn(doc, ("arm",), True))
    assert duet.do(act.Teach("Joint object")).values == {"endpoint": (0.1, 0.2, 0.3, 0.4)}


def test_what_is_no_target_or_is_measured_by_nothing_is_refused(duet):  # R-D23
    measuring(duet, "arm")
    assert "no type of target" in str(duet.no(act.Teach("Joint job")).reason)
    assert "typed in" in str(duet.no(act.Teach("Pause object")).reason)


def test_a_runtime_that_does_not_answer_says_why(duet):  # R-X01
    doc, _ = measuring(duet, "arm")
    duet.do(act.Turn(doc, ("arm",), True))
    duet.rebuffs = {live.Read: request.Refused(Reason.plain("not now"))}
    assert str(duet.no(act.Teach("Joint object")).reason) == "not now"
    duet.rebuffs = {live.Survey: request.Refused(Reason.plain("it is gone"))}
    assert str(duet.no(act.Teach("Joint object")).reason) == "it is gone"
