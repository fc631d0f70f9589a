import os
import time
from dataclasses import replace
from threading import Thread

import pytest
from msgspec import structs

from kit.plans.plan_builder import PlanBuilder, action
from onika.desk.plan.preparation import prepare
from onika.desk.run import forecast as room
from onika.desk.run.forecast import Forecast
from onika.files import appl
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.wire import event, request
from onika.words.fault import Place
from onika.words.reason import Reason

HEAD = "from onika.module import Module, finish\nclass Work(Module):\n    trigger = True\n    def cycle(self):\n"
AT_ONCE = HEAD + "        return finish()\n"
NEVER = HEAD + "        pass\n"
OUTSIDE = HEAD + "        open('there', 'w')\n"


def plan_of(source, count=1):
    shop = PlanBuilder()
    shop.task("work", source)
    return shop.plan([action("work") for _ in range(count)])


@pytest.mark.parametrize(("at_s", "index"), [(-1.0, None), (0.5, 0), (2.0, 1), (9.0, 1)])
def test_what_is_understood_late_happened_in_the_action_of_its_time(at_s, index):  # R-E16
    plan = plan_of(AT_ONCE, 2)
    forecast = Forecast(plan, ())
    for began_s, number in ((0.0, 0), (2.0, 1)):
        forecast.hear(event.Began(0, number, 2, "work", began_s))
    forecast.hear(event.Mishap("yard", Reason.plain("it touches"), (), at_s, b""))
    (mishap,) = forecast.result.mishaps
    assert mishap.action == (None if index is None else plan.flows[0].actions[index])


@pytest.mark.parametrize(
    ("key", "kind", "is_told"),
    [
        ("workcell.touches", "guarded object", False),
        ("workcell.carried_touches", "guarded object", False),
        ("workcell.meets", "guarded object", True),
        ("workcell.touches", "cartesian object", True),
    ],
)
def test_what_a_motion_touches_that_limits_its_force_is_meant(key, kind, is_told):  # R-E16, R-D25
    forecast = Forecast(plan_of(AT_ONCE, 2), (request.TargetValues(0, 1, kind, (1.0,)),))
    for began_s, number in ((0.0, 0), (2.0, 1)):
        forecast.hear(event.Began(0, number, 2, "work", began_s))
    for at_s in (1.0, 3.0):
        called = dict.fromkeys(("who", "what", "hand", "other"), "it")
        forecast.hear(event.Mishap("yard", Reason.of(key, **called), (), at_s, b""))
    assert [mishap.at_s for mishap in forecast.result.mishaps] == ([1.0, 3.0] if is_told else [1.0])


class Scripted:
    """A runtime that answers and tells what a test wants."""

    pid = 1

    def __init__(self, answers, happenings=()):
        self.answers, self.happenings = answers, happenings

    def __call__(self, *_given, **_named):
        return self

    def __enter__(self):
        return self

    def __exit__(self, *_ended):
        pass

    def ask(self, message):
        return self.answers.get(type(message), request.Done())

    def events(self, _timeout_s):
        return self.happenings


FAULT = request.FaultText("work.py", 1, Reason.plain("it cannot be used"), Reason.plain("nothing is"))


@pytest.mark.parametrize(
    ("runtime", "words"),
    [
        (Scripted({request.Prepare: request.Refused(Reason.plain("no room"))}), "no room"),
        (Scripted({request.Prepare: request.Prepared((FAULT,))}), "it cannot be used"),
        (Scripted({request.Prepare: request.Prepared((), worlds={"hall": False, "boxes": True})}), "hall is real"),
        (Scripted({request.Begin: request.Refused(Reason.plain("no place"))}), "no place"),
        (Scripted({}, [event.Began(0, 0, 1, "work", 601.0)]), "more than 10 minutes"),
    ],
)
def test_why_a_plan_is_not_foreseen_to_its_end_is_said(monkeypatch, runtime, words):  # R-E16
    monkeypatch.setattr(room, "LaunchedRuntime", runtime)
    assert words in str(Forecast(plan_of(NEVER), ()).carry_out().cause)


@pytest.mark.site
def test_a_module_that_reaches_outside_is_kept_from_it(tmp_path, monkeypatch):  # R-E16
    monkeypatch.chdir(tmp_path)
    assert "touches nothing outside" in str(Forecast(plan_of(OUTSIDE), ()).carry_out().cause)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.site
def test_one_that_does_not_come_to_its_end_is_ended(monkeypatch):  # R-E16
    monkeypatch.setattr(room, "PATIENCE_S", 0.2)
    assert Forecast(plan_of(NEVER), ()).carry_out().cause.key == "desk.forecast_late"


@pytest.mark.site
def test_one_that_is_ended_leaves_no_process():  # R-E16
    forecast = Forecast(plan_of(NEVER), ())
    thread = Thread(target=forecast.carry_out)
    thread.start()
    while (pid := forecast.pid) is None:
        time.sleep(0.01)
    forecast.end()
    thread.join(20.0)
    assert not thread.is_alive()
    assert str(forecast.result.cause)
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


def test_one_that_is_ended_before_it_begins_begins_nothing():  # R-E16
    forecast = Forecast(plan_of(NEVER), ())
    forecast.end()
    assert forecast.carry_out().lasts_s == 0.0
    assert forecast.pid is None


@pytest.mark.site
def test_a_hand_that_was_not_opened_is_foreseen_to_touch_the_box():  # R-E16
    site = open_site([], {}, None)
    syntax, _ = site.syntax()
    path = shipped() / "boxes" / "appl" / "assemble.appl"
    whole, _ = appl.read(path.read_text(), "assemble", str(path), syntax)
    (flow,) = whole.flows
    closed = replace(whole, flows=(replace(flow, steps=flow.steps[1:5]),))  # without the one that opens it
    prepared = prepare(closed, Place("closed"), site, syntax)
    result = Forecast(prepared.plan, prepared.targets).carry_out()
    assert "the hand did not come to its target" in str(result.cause)
    assert [str(mishap.text) for mishap in result.mishaps] == ["the hand touches the box with the triangle"]
    (mishap,) = result.mishaps
    assert mishap.action.name == prepared.plan.flows[0].actions[1].name
    assert 0.0 < mishap.at_s < result.lasts_s
    assert [str(said) for said in result.standing] == ["the lamp is dark"]
    assert result.scenes[mishap.world]["shapes"]


@pytest.mark.site
@pytest.mark.parametrize(("source", "words"), [(AT_ONCE, ""), (OUTSIDE, "may only compute")])
def test_code_of_others_is_foreseen_in_a_sandbox(tmp_path, monkeypatch, source, words):  # R-E16, R-X16
    monkeypatch.chdir(tmp_path)
    plan = plan_of(source)
    sandboxed = tuple(structs.replace(code, is_sandboxed=True) for code in plan.code)
    result = Forecast(structs.replace(plan, code=sandboxed), ()).carry_out()
    assert words in str(result.cause)
    assert bool(str(result.cause)) is bool(words)
    assert list(tmp_path.iterdir()) == []
