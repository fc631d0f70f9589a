from base64 import b64decode
from dataclasses import replace

import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.runs import forecaster as room
from onika.desk.environment.runs.forecaster import REST_S, Forecaster, told
from onika.desk.environment.state.open_application import Foretelling, Judgement
from onika.desk.plan.preparation import PreparedRun
from onika.desk.run.forecast import ForecastResult, ForeseenMishap
from onika.wire import act
from onika.wire.plan import Plan, PlannedAction
from onika.wire.view import FaultView
from onika.words.reason import Reason

WATCHED = {"yard": True, "field": False}
"""Of each world whether it says what happens in it that is not meant."""


class Work:
    """A worker that does what it is asked when a test wants it, and keeps what it tells."""

    def __init__(self, fixture):
        self.fixture = fixture
        self.asked = []
        self.is_closed = False

    def do(self, work):
        self.asked.append(work)

    def tell(self, change):
        self.fixture.environment.become(change)

    def carry_out(self):
        self.asked.pop(0)()

    def close(self):
        self.is_closed = True


class Foreseen:
    """A forecast without a process; `during` is called while it is carried out."""

    result = ForecastResult(3.5, standing=(Reason.plain("all is well"),))
    during = staticmethod(lambda: None)

    def __init__(self, _plan, _targets):
        self.is_ended = False

    def end(self):
        self.is_ended = True

    def carry_out(self):
        type(self).last = self
        type(self).during()
        return self.result


class Desk(AppFixture):
    """An environment with one application that could run, and who foresees it."""

    def __init__(self, folder):
        super().__init__(folder)
        self.work = Work(self)
        self.forecaster = Forecaster(None, self.work)
        self.now_s = 0.0
        self.doc = self.begun("open", "grip")
        self.judge()

    @property
    def opened(self):
        return self.environment.model.applications[self.doc]

    def judge(self, *faults):
        judgement = Judgement(self.opened.application, faults)
        model = self.environment.model
        self.environment.model = model.with_application(replace(self.opened, judgement=judgement))

    def look(self, after_s=REST_S):
        self.forecaster.look(self.environment.model, self.now_s)
        self.now_s += after_s
        self.forecaster.look(self.environment.model, self.now_s)

    @property
    def shown(self):
        return self.environment.tree.applications[self.doc]


@pytest.fixture
def desk(tmp_path, monkeypatch):
    plan = Plan("test", (), ())
    monkeypatch.setattr(room, "Forecast", Foreseen)
    monkeypatch.setattr(room, "ready", lambda *_given, **_named: PreparedRun("test", None, plan, (), ()))
    monkeypatch.setattr(
        Foreseen, "result", ForecastResult(3.5, standing=(Reason.plain("all is well"),), watched=WATCHED)
    )
    monkeypatch.setattr(Foreseen, "during", staticmethod(lambda: None))
    return Desk(tmp_path)


def test_what_rests_and_could_run_is_foreseen_once(desk):  # R-E16
    desk.look(REST_S / 2)
    assert desk.work.asked == []
    desk.look(REST_S)
    assert desk.shown.forecast.state == "going"
    desk.work.carry_out()
    forecast = desk.shown.forecast
    assert (forecast.state, forecast.lasts_s, list(map(str, forecast.standing))) == ("whole", 3.5, ["all is well"])
    assert (forecast.worlds, forecast.unwatched) == (("yard", "field"), ("field",))
    desk.look()
    assert desk.work.asked == []


def test_what_could_not_run_or_is_not_judged_yet_is_not_foreseen(desk):  # R-E16
    desk.judge(FaultView(Reason.plain("a hole")))
    desk.look()
    desk.add(desk.doc, "wait")
    desk.look()
    assert desk.work.asked == []
    assert desk.shown.forecast.state == "none"


def test_what_happens_is_told_at_its_step(desk, monkeypatch):  # R-E16
    step = desk.opened.application.flows[0].steps[1].number
    within = PlannedAction("grip", "grip", None, "other.appl", (), (), "", line=7, spot=(step, 7))
    mishaps = [
        ForeseenMishap(Reason.plain("it touches"), 1.25, within, "yard", b"", ()),
        ForeseenMishap(Reason.plain("it falls"), 2.0, None, "yard", b"", ()),
    ]
    monkeypatch.setattr(Foreseen, "result", ForecastResult(3.5, Reason.plain("it stops"), mishaps))
    desk.look()
    desk.work.carry_out()
    forecast = desk.shown.forecast
    assert (forecast.state, str(forecast.cause), forecast.mishaps) == ("part", "it stops", 2)
    told_at = {(fault.step, str(fault.text), fault.level) for fault in desk.shown.faults.values()}
    assert {fault.instant for fault in desk.shown.faults.values()} == {1, 2}
    assert told_at == {(step, "at 1.2 s it touches", "warning"), (0, "at 2.0 s it falls", "warning")}


def test_the_instant_of_what_happens_is_shown_as_long_as_it_is_foreseen(desk, monkeypatch):  # R-E16
    mishap = ForeseenMishap(Reason.plain("it touches"), 1.25, None, "yard", b"\0\0\x80?", ("lamp",))
    scenes = {"yard": {"shapes": []}}
    monkeypatch.setattr(Foreseen, "result", ForecastResult(3.5, mishaps=[mishap], scenes=scenes))
    desk.look()
    desk.work.carry_out()
    shown = desk.do(act.ForeseenInstant(desk.doc, 1))
    assert (shown.world, shown.at_s, shown.scene, shown.lit) == ("yard", 1.25, {"shapes": []}, ("lamp",))
    assert b64decode(shown.poses) == mishap.poses
    assert desk.no(act.ForeseenInstant(desk.doc, 2)).reason.key == "run.not_foreseen_any_more"
    desk.add(desk.doc, "wait")
    assert desk.no(act.ForeseenInstant(desk.doc, 1)).reason.key == "run.not_foreseen_any_more"


def test_the_next_edit_ends_it_and_what_came_of_it_is_not_told(desk, monkeypatch):  # R-E16
    def edit():
        desk.add(desk.doc, "wait")
        desk.look(0.0)
        assert Foreseen.last.is_ended

    monkeypatch.setattr(Foreseen, "during", staticmethod(edit))
    desk.look()
    desk.work.carry_out()
    assert desk.shown.forecast.state == "none"
    desk.judge()
    desk.look()
    assert len(desk.work.asked) == 1


def test_one_that_is_closed_is_told_to_nobody(desk, monkeypatch):  # R-E16
    monkeypatch.setattr(Foreseen, "during", staticmethod(lambda: desk.do(act.Close(desk.doc, discards=True))))
    desk.look()
    desk.work.carry_out()
    assert desk.doc not in desk.environment.tree.applications


def test_who_leaves_ends_it(desk, monkeypatch):  # R-E16
    monkeypatch.setattr(Foreseen, "during", staticmethod(desk.forecaster.close))
    desk.look()
    desk.work.carry_out()
    assert Foreseen.last.is_ended
    assert desk.work.is_closed


def test_what_is_foreseen_of_an_earlier_content_is_not_shown(desk):  # R-E16
    former = Foretelling(desk.opened.application, (), is_going=False, lasts_s=1.0)
    desk.add(desk.doc, "wait")
    desk.environment.become(lambda model: told(model, desk.doc, former))
    assert desk.shown.forecast.state == "none"
