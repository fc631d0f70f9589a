from dataclasses import replace

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.initial_model import opened
from onika.desk.environment.outcome.outcome import Done
from onika.model.task import Task
from onika.store.site import open_site
from onika.wire import act, live
from onika.wire.sheet import InputSheet, ModuleSheet, PortSheet

SITE_MODEL, _ = opened(open_site([], {}, None), None, {})
ARM = Task("arm", "arm", outvar=("Q_MEZ", "V_MEZ", "TABLE"), frequency=100.0)
MOVE = Task("move", "move", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0, object_type="Joint job")
SHEETS = {
    "arm": ModuleSheet(
        (
            PortSheet("OUTVAR", "Q_MEZ", "double[NDOF]", "rad", ""),
            PortSheet("OUTVAR", "V_MEZ", "double[NDOF]", "rad/s", ""),
            PortSheet("OUTVAR", "TABLE", "double[2,2]", "-", ""),
        ),
        (),
        (),
        False,
        False,
        True,
        0,
        "",
    ),
    "move": ModuleSheet(
        (PortSheet("INVAR", "Q_MEZ", "double[NDOF]", "rad", ""),),
        (
            InputSheet("endpoint", "double[NDOF]", "rad", "", None, None, None),
            InputSheet("duration", "double", "s", "", 0.1, 600.0, None),
        ),
        (),
        True,
        False,
        False,
        0,
        "",
    ),
}
NOW = {"Q_MEZ": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], "V_MEZ": [1.0] * 6, "TABLE": [[1.0, 2.0], [3.0, 4.0]]}


class Reader(LiveRuntime):
    def ask(self, wish):
        if isinstance(wish, live.Describe):
            return live.Described({code.digest: SHEETS[code.module] for code in wish.code})
        return super().ask(wish)


@pytest.fixture
def desk(tmp_path):
    desk = FakeRuntimeEnv(tmp_path, (ARM, MOVE), Reader())
    desk.environment.become(lambda model: Done(replace(model, syntax=SITE_MODEL.syntax)))
    return desk


def living(desk):
    doc = desk.connected("arm", "move")
    desk.runtime.variables[desk.document(doc).live.subsystem] = NOW
    return doc


def test_a_variable_makes_those_targets_that_take_what_it_holds_now(desk):  # R-C30
    doc = living(desk)
    view = desk.do(act.FitTargets("Q_MEZ", doc))
    (fit,) = [fit for fit in view.fits if fit.type == "Joint object"]
    assert (fit.item, fit.values) == ("endpoint", ("0.1", "0.2", "0.3", "0.4", "0.5", "0.6"))
    assert (view.variable, view.shape) == ("Q_MEZ", "double[6] rad")
    assert str(view.source) == f"Q_MEZ, as it is now in {desk.document(doc).live.subsystem}"


def test_the_task_that_gives_it_need_not_be_on(desk):  # R-C30: any variable of the table
    doc = living(desk)
    assert desk.state(doc, "arm") == "OFF"
    assert desk.do(act.FitTargets("Q_MEZ", subsystem=desk.document(doc).live.subsystem)).fits


def test_a_velocity_is_no_place(desk):  # R-C30
    doc = living(desk)
    types = {fit.type for fit in desk.do(act.FitTargets("V_MEZ", doc)).fits}
    assert "Joint object" not in types


def test_what_fits_no_type_is_refused_in_words(desk):  # R-C30, R-X01
    doc = living(desk)
    text = str(desk.no(act.FitTargets("TABLE", doc)).reason)
    assert text.startswith("TABLE is double[2,2], which no type of target takes: Joint target: ")


def test_what_is_not_there_or_not_connected_is_refused(desk):  # R-C30, R-X01
    doc = living(desk)
    assert "has no variable 'NONE'" in str(desk.no(act.FitTargets("NONE", doc)).reason)
    other = desk.new("arm")
    no = desk.no(act.FitTargets("Q_MEZ", other))
    assert no.remedies[0].act == act.Connect(other)
    assert desk.no(act.FitTargets("Q_MEZ", "nowhere")).reason.key == "run.configuration_closed"


def test_the_target_is_written_as_any_other_and_taken_back(desk, tmp_path):  # R-C30, R-D08, R-X10
    doc = living(desk)
    fit = next(fit for fit in desk.do(act.FitTargets("Q_MEZ", doc)).fits if fit.type == "Joint object")
    picture = "7" * 1024
    desk.do(act.MakeTarget("here", fit.type, (fit.values, ("2",)), picture, base=str(tmp_path)))
    file = tmp_path / "dict" / "here.onk"
    assert "0.6" in file.read_text()
    desk.do(act.Undo(""))
    assert not file.exists()
