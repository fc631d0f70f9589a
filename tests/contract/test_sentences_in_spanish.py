"""What the page knows in Spanish of the sentences that are said here: whoever changes one here sees it there."""

import re
from functools import partial
from pathlib import Path

import pytest

from kit.laboratory import HOLE, job
from kit.run_fixture import RunFixture
from onika.desk.environment.outcome.fault_text import said
from onika.desk.environment.runs.readiness import Judge, judged
from onika.desk.environment.runs.runtime_loss import lost
from onika.wire import act
from onika.words.fault import Fault, Place

TABLE = Path(__file__).parents[2] / "browser" / "src" / "texts" / "es.heard.ts"
PATTERNS = [
    re.compile(one.replace("[^]", r"[\s\S]")) for one in re.findall(r"^  \[/(.+?)/, '", TABLE.read_text(), re.MULTILINE)
]


def is_known(text):
    return any(one.search(text) for one in PATTERNS)


def test_what_is_unknown_is_not_taken_for_known():
    assert len(PATTERNS) > 40 and not is_known("a sentence that nobody has said")


def test_what_another_did_and_is_taken_back():  # R-X10
    assert is_known("“inserting a” in play was done on another page, and is taken back here; Redo does it again")
    assert is_known("“inserting a” in play was done on another page, and is done again here")


@pytest.mark.parametrize(
    ("expected", "found"),
    [
        ("an action in flow 2", "none"),
        ("edges that fit", "`b` (Joint job) behind `a` (Number job), at step 1 of flow 0"),
        ("a target within reach", "p: out of reach: the wrist would be 1.9 m from the shoulder, possible are 0..0.8 m"),
        ("a posture of scara where puma would be", "home: the hand would lean 180 degrees"),
        ("a device of world boxes (arm)", "DEVICE boxes:bulb"),
        ("the device that puma means as b:x", "expected y, found z"),
        ("device b:arm for one task", "task puma claims it too"),
        ("a task that supplies the constant NDOF", "none"),
        ("a task with the outputs of a, that works in its place", "`b` does not write X, as `a` does"),
        ("values for jtraj", "home: expected 7 values, found 5"),
        ("a Joint object behind it", "none behind `a`, step 3 of flow 0"),
        ("the configuration aC", "none for `aC`, step 3 of flow 0"),
        ("tags as often in each flow", "flow1 waits at A (play:7, putC) for flow0, which has ended by then"),
        ("the loop tag l twice in flow 0", "1 times, last at `b`, step 2 of flow 0"),
    ],
)
def test_what_is_wrong_with_an_application(expected, found):  # R-X01
    assert is_known(said(Fault(Place("play.appl", 3), expected, found, "the application is not run")))


def test_what_is_judged_and_what_can_be_done(tmp_path):  # R-X01, R-E01
    play = RunFixture(tmp_path)
    judge, doc = Judge(play.site), play.open([job("aC"), HOLE, job("newC")], [])
    for case in judge.cases(play.environment.model):
        play.environment.become(partial(judged, doc=case.opened.id, judgement=judge.judge(case)))
    faults = list(play.environment.tree.applications[doc].faults.values())
    assert len(faults) > 2
    assert all(is_known(one.text) and all(is_known(remedy.label) for remedy in one.remedies) for one in faults)


def test_how_a_run_begins_and_ends(tmp_path):  # R-E10, R-E14
    play = RunFixture(tmp_path)
    play.run(play.open([job("aC")]))
    play.environment.become(lambda model: lost(model, "the runtime is gone: it ended"))
    assert len(play.says) > 2 and all(is_known(one.text) for one in play.says)
    assert is_known(play.no(act.Steer("abort")).reason)
