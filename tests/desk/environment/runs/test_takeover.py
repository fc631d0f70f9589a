from dataclasses import replace

import pytest
from msgspec import structs

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import Laboratory, job
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.runs.takeover import Fates
from onika.wire import act, event, live, request
from onika.wire.plan import Plan, PlannedFlow, PlannedTask
from onika.wire.sheet import ModuleSheet
from onika.words.reason import NOTHING


@pytest.fixture
def play(tmp_path):
    files = Laboratory(tmp_path)
    files.module("rival", "# rival\n")
    files.plain_task("rival", writes="D", local="DEVICE arm\n")
    return RunFixture(tmp_path)


def task(name, module="", digest="1", local=(), **changes):
    planned = PlannedTask(name, module or name, digest, "", "rt0", 10.0, "periodic", (), (), (), (), (), local)
    return structs.replace(planned, **changes)


def plan(*tasks):
    return Plan("play", (PlannedFlow("flow0", tasks, ()),), ())


ARM = (("DEVICE", ("arm",)),)


@pytest.mark.parametrize(
    ("living", "planned", "fate"),
    [
        (task("a"), task("a", rtpu="rt1", frequency=50.0, place="elsewhere"), "again"),
        (task("a"), task("a", digest="2"), "exchanged"),
        (task("a"), task("a", local=(("SPEED", ("1",)),)), "exchanged"),
        (task("a"), task("b"), "ends"),
    ],
)
def test_each_task_has_one_fate(living, planned, fate):  # R-C18, Equation (1)
    fates = Fates.between([living], plan(planned))
    where = {name for name in ("again", "exchanged", "gives_way", "ends") if getattr(fates, name)}
    assert where == {fate} and fates.comes == (("b",) if fate == "ends" else ())


@pytest.mark.parametrize("rival", [task("b", module="a"), task("b", local=ARM)])
def test_who_has_the_module_or_the_device_of_another_gives_way_to_it(rival):  # R-C18, reading 30
    fates = Fates.between([task("a", local=ARM)], plan(rival, task("c")))
    assert (fates.gives_way, fates.ends, fates.comes) == ((("a", "b"),), (), ("c",))


def question(play, doc, **options):
    no = play.answer(act.Run(doc, **options)).no
    return "" if no is None else str(no.reason), () if no is None else no.remedies


def test_one_question_says_what_happens_to_each_task_and_what_is_put_back(play):  # R-C18, R-E12
    lower = play.connected("rival", "b", "c")
    play.do(act.Turn(lower, ("c",), True))
    sheets = {"c": ModuleSheet((), (), (), False, False, False, 0, "")}
    play.environment.become(lambda model: Done(replace(model, libraries=replace(model.libraries, sheets=sheets))))
    reason, remedies = question(play, play.open([job("aC"), job("bC")]))
    assert "b is in both: it ends, and begins anew; rival gives way to a; c goes OFF and ends; " in reason
    assert "afterwards Untitled-1 is put back, c ON again where all actions were done" in reason
    assert [str(remedy.label) for remedy in remedies] == ["Take over and run"]
    assert play.carried(live.Close) == [] and play.state(lower, "c") == "ON"
    play.do(remedies[0].act)
    assert play.view.state == "running" and play.carried(live.Close) == [live.Close("Untitled-1")]


def test_what_it_takes_over_is_saved_first_if_the_user_wishes(play, tmp_path):  # R-E12
    conf = play.do(act.Open(str(tmp_path / "conf" / "aC.conf")))
    play.do(act.Connect(conf))
    play.do(act.Rate(conf, "a", 50.0))
    doc = play.open([job("aC")])
    reason, (save, as_filed) = question(play, doc)
    assert "aC is changed here and not saved" in reason and "afterwards aC is put back" in reason
    play.do(as_filed.act)
    assert play.document(conf).is_dirty
    assert play.carried(request.Prepare)[-1].plan.flows[0].actions[0].rates == (("a", 100.0),)
    play.end()
    assert play.state(conf, "a") == "OFF"
    play.do(save.act)
    assert not play.document(conf).is_dirty
    assert play.carried(request.Prepare)[-1].plan.flows[0].actions[0].rates == (("a", 50.0),)


def test_what_is_in_the_middle_of_a_switch_is_not_taken_over(play):  # R-C18
    lower = play.connected("a")
    doc = play.open([job("aC")])
    given = []
    play.is_held_back = True
    play.environment.do(act.Turn(lower, ("a",), True), "me", given.append)
    change = play._waiting.popleft()
    play.environment.do(act.Run(doc, confirmed=True), "me", given.append)
    survey = play._waiting.popleft()
    play.environment.replied(survey, play.runtime.ask(survey.asked))
    (refused,) = [answer.no for answer in given if answer.no is not None]
    assert "is being changed at this moment" in str(refused.reason)
    assert refused.remedies[0].act == act.Run(doc, confirmed=True)
    play.environment.replied(change, play.runtime.ask(change.asked))
    play.is_held_back = False
    play.hear()
    play.pump()
    assert play.state(lower, "a") == "ON"
    play.do(refused.remedies[0].act)
    assert play.view.state == "running"


def test_two_browsers_that_take_it_over_begin_one_run(play):  # R-C18, R-X01
    play.connected("a")
    doc = play.open([job("aC")])
    given = []
    play.is_held_back = True
    for person in ("me", "you"):
        play.environment.do(act.Run(doc, confirmed=True), person, given.append)
    play.is_held_back = False
    play.pump()
    assert [answer.no is None for answer in given] == [False, True]
    assert len(play.carried(live.Close)) == len(play.carried(request.Begin)) == 1


def test_tasks_that_nobody_shows_are_told_to_be_gone_for_good(play):  # R-C18, reading 30
    lower = play.connected("a")
    play.do(act.New())
    play.do(act.Close(lower, discards=True, alive="leave"))
    reason, remedies = question(play, play.open([job("aC")]))
    assert "nobody shows Untitled-1 here, so that is not put back" in reason
    play.do(remedies[0].act)
    play.end()
    assert "Untitled-1" not in play.runtime.lives


def test_an_outcome_of_another_change_does_not_begin_it(play):  # reading 30
    play.connected("a")
    play.tell(event.Edited("elsewhere", 77, NOTHING, 1.0))
    play.do(act.Run(play.open([job("aC")]), confirmed=True))
    assert play.view.state == "running"
