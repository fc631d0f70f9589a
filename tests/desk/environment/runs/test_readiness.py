import os
import random
from dataclasses import replace
from functools import partial

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import HOLE, job
from kit.worlds.file_cells import CELL
from onika.desk.environment.runs.readiness import ReadinessCase, ReadinessJudge, judged
from onika.desk.environment.state.open_application import OpenApplication
from onika.model.application import AppFlow, Application, Branch, Hole, Icon
from onika.model.flow_path import numbered, spots
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.wire import act


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def look(play, judge, cases):
    for case in cases:
        play.environment.become(partial(judged, doc=case.opened.id, judgement=judge.judge(case)))
    return len(cases)


def shown(play, doc):
    return sorted(str(fault.text) for fault in play.environment.tree.applications[doc].faults.values())


def test_what_is_open_is_judged_once_and_again_after_a_change(play):  # R-E01
    judge = ReadinessJudge(play.site)
    doc = play.open([job("aC"), HOLE, job("bC")])
    assert look(play, judge, judge.cases(play.environment.model)) == 1
    assert play.environment.tree.applications[doc].is_judged
    assert shown(play, doc) == ["an action is missing here"]
    assert judge.cases(play.environment.model) == ()
    play.do(act.RemoveIcons(doc, (3,)))
    assert not play.environment.tree.applications[doc].is_judged
    assert look(play, judge, judge.cases(play.environment.model)) == 1
    assert judge.cases(play.environment.model) == ()


def test_files_that_change_or_come_are_seen(play):  # R-E01
    judge = ReadinessJudge(play.site)
    doc = play.open([job("aC"), job("newC")])
    look(play, judge, judge.cases(play.environment.model))
    assert shown(play, doc) == ["there is no configuration newC"]
    assert judge.stale(play.environment.model) == ()
    play.files.configuration("newC", "c 100")
    assert look(play, judge, judge.stale(play.environment.model)) == 1
    assert shown(play, doc) == []
    path = play.files.configuration("newC", "nobody 100")
    os.utime(path, ns=(1, 1))
    look(play, judge, judge.stale(play.environment.model))
    assert shown(play, doc) == ["there is no task nobody"]


def test_what_is_changed_here_and_not_saved_is_a_warning(play, tmp_path):  # R-E12
    judge = ReadinessJudge(play.site)
    doc = play.open([job("aC")])
    conf = play.do(act.Open(str(tmp_path / "conf" / "aC.conf")))
    look(play, judge, judge.cases(play.environment.model))
    play.do(act.Rate(conf, "a", 50.0))
    look(play, judge, judge.cases(play.environment.model))
    (fault,) = play.environment.tree.applications[doc].faults.values()
    assert fault.level == "warning" and fault.step == 1 and fault.remedies[0].act == act.Save(conf)


def test_a_judgement_that_says_the_same_changes_nothing(play):
    judge = ReadinessJudge(play.site)
    doc = play.open([HOLE, job("aC")])
    (case,) = judge.cases(play.environment.model)
    look(play, judge, (case,))
    before = play.environment.model
    look(play, judge, (case,))
    assert play.environment.model is before
    assert judged(before, "a9", judge.judge(case)).model is before
    assert play.environment.tree.applications[doc].is_judged


def test_without_a_syntax_nothing_is_judged(tmp_path):
    sitting = EnvironmentFixture(tmp_path)
    judge = ReadinessJudge(sitting.site)
    assert judge.cases(sitting.environment.model) == judge.stale(sitting.environment.model) == ()


@pytest.mark.parametrize("seed", range(5))
def test_whatever_stands_in_an_application_it_is_judged(seed):  # R-E01
    rng = random.Random(seed)
    site = open_site([], {}, None)
    syntax, _ = site.syntax()
    judge = ReadinessJudge(site)
    pool = [icon for base in site.directories for name in base.onikons if (icon := base.onikon(name, syntax)[0])]

    def some_icon():
        icon = rng.choice(pool)
        icon = replace(icon, type=rng.choice(["Odd job", "Odd object", "Odd"])) if rng.random() < 0.1 else icon
        icon = replace(icon, name="goneC") if rng.random() < 0.1 else icon
        icon = replace(icon, values=((1.0,),)) if rng.random() < 0.1 else icon
        tags = {"synch_tag": rng.choice([None, None, "a", "b"]), "while_tag": rng.choice([None, None, "l", "m"])}
        conditions = {"marker_if": rng.choice(["", "Q > 1", "bad("]), "while_if": rng.choice(["", "X < 2"])}
        return Icon(icon, rng.random() < 0.2, while_test=rng.random() < 0.5, **tags, **conditions)

    def some_flow(depth=0):
        return AppFlow(tuple(some_step(depth) for _ in range(rng.randrange(6))))

    def some_step(depth):
        dice = rng.random()
        if dice < 0.15:
            return Hole()
        if dice < 0.3 and depth < 3:
            conditions = tuple(rng.choice(["Q > 1", "nonsense"]) for _ in range(rng.randrange(3)))
            return Branch(tuple(some_flow(depth + 1) for _ in range(rng.randrange(4))), conditions)
        return some_icon()

    for _ in range(20):
        flows = tuple(some_flow() for _ in range(rng.randrange(4)))
        application, last = numbered(Application("odd", rng.random() < 0.5, flows), 0)
        verdict = judge.judge(ReadinessCase(OpenApplication("a1", application, last), syntax, ()))
        assert verdict.of is application
        places = {0, *spots(application)}
        assert all(fault.step in places and str(fault.text) for fault in verdict.faults)


def test_flows_that_nothing_chooses_are_told_with_what_would_choose(play):  # R-D04, R-X01
    judge = ReadinessJudge(play.site)
    doc = play.open([job("aC")], [job("bC")])
    look(play, judge, judge.cases(play.environment.model))
    (fault,) = play.environment.tree.applications[doc].faults.values()
    assert (
        str(fault.text) == "run by itself, only flow 0 runs: nothing before it chooses another"
        and fault.level == "warning"
    )
    play.do(fault.remedies[0].act)
    assert any(step.kind == "branch" for step in play.environment.tree.applications[doc].steps.values())


def test_a_flow_that_a_guest_carries_out_bears_its_name(play):  # R-A20
    judge = ReadinessJudge(play.site)
    play.files.module("asks", "from onika.module import Module\n\nclass Asks(Module):\n    trigger = True\n")
    play.files.plain_task("asks", local="GUEST oracle\n")
    play.files.configuration("asksC", "asks 100")
    theirs, mixed = play.open([job("asksC")]), play.open([job("asksC"), job("aC")], name="mixed")
    look(play, judge, judge.cases(play.environment.model))
    shown = play.environment.tree.applications
    assert (shown[theirs].guests, shown[mixed].guests) == ({"flow0": "oracle"}, {})


def test_files_of_worlds_that_change_are_seen_and_what_is_wrong_with_them_told(tmp_path):  # R-E01, R-X19
    play = RunFixture(tmp_path)
    lab = play.files.path
    for name, text in CELL.items():
        (lab / name).parent.mkdir(parents=True, exist_ok=True)
        (lab / name).write_text(text)
    task = (shipped() / "arms" / "module" / "arm_pos.rmod").read_text()
    (lab / "module" / "elbow.rmod").write_text(task.replace("workshop:jointed_bay", "cell:elbow_left"))
    play.files.configuration("elbowC", "elbow 100")
    judge = ReadinessJudge(open_site((lab,), {}, None))
    doc = play.open([job("elbowC")])
    look(play, judge, judge.cases(play.environment.model))
    before = shown(play, doc)
    assert judge.stale(play.environment.model) == ()
    for name in ("robot/elbow.xml", "robot/elbow.robot", "world/cell.world"):
        (lab / name).write_text(CELL[name].replace("FLOOR 0", "FLOOR low"))
        os.utime(lab / name, ns=(1, 1))
        assert look(play, judge, judge.stale(play.environment.model)) == 1
    assert any("FLOOR low" in text for text in shown(play, doc))
    (lab / "world/cell.world").write_text(CELL["world/cell.world"])
    look(play, judge, judge.stale(play.environment.model))
    assert shown(play, doc) == before
