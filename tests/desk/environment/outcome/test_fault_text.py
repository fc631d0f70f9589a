import pytest

from onika.desk.environment.outcome.fault_text import said, together
from onika.words.fault import Fault, Place

HERE = Place("play.appl", 3)
FLOW = "flow 1, step 3, branch 0"


@pytest.mark.parametrize(
    ("expected", "found", "words"),
    [
        (
            f"the loop tag l twice in {FLOW}",
            f"1 times, last at `b`, step 2 of {FLOW}",
            "the loop l is marked at one icon only",
        ),
        (
            "edges that fit",
            "`b` (Joint job) behind `a` (Number job), at step 1 of flow 0",
            "b (Joint job) does not fit behind a",
        ),
        ("edges that fit", "Application end behind `a` (Joint job), at step 1 of flow 0", "nothing may end behind a"),
        ("a Joint object behind it", "none behind `a`, step 3 of flow 0", "a wants a Joint target behind it"),
        ("module led once in a flow", "also in task lamp", "its module led is used already, by lamp"),
        ("the configuration aC", "none for `aC`, step 3 of flow 0", "there is no configuration aC"),
        ("the task pd", "none for `aC`, step 0 of flow 1 of `inner`", "there is no task pd"),
        ("an action in flow 2", "none", "flow 2 is empty"),
        (
            "tags as often in each flow",
            "flow1 waits at A (play:7, putC) for flow0, which has ended by then, when flow0 takes flow 1 of a branch",
            "flow1 could wait at the tag A in vain: flow0 does not come there as often",
        ),
        (
            "tags in an order in which the flows can meet",
            "flow0 waits at A (play:2, putC) for flow1, which waits at B (play:9, aC) for flow0",
            "flow0 waits at the tag A for flow1, which waits at the tag B for flow0: neither comes",
        ),
        ("a Joint job, as its trigger `jt` says", "Complete job for `a`, step 0 of flow 0", "a is a Complete job here"),
        ("a target within reach", "p: out of reach: the wrist", "p is out of reach: the wrist"),
        ("a target within reach", "far: joint 3 at 9.00 rad is beyond 3.93", "far cannot be reached: joint 3"),
        ("a posture of scara where puma would be", "home: the hand leans", "scara cannot come to home: the hand leans"),
        (
            "a device of world boxes (arm, lamp)",
            "DEVICE boxes:bulb",
            "there is no device boxes:bulb; boxes has arm, lamp",
        ),
        ("a world (boxes)", "DEVICE shed:arm", "there is no world for the device shed:arm, but boxes"),
        (
            "the device that puma means as b:x",
            "expected y, found z",
            "b:x is not the device that puma means: expected y",
        ),
        ("device b:arm for one task", "task puma claims it too", "puma and another task both claim b:arm"),
        ("devices of boxes that can be used together", "'a' is kinematic", "'a' is kinematic"),
        ("a task with the outputs of a, that works in its place", "`b` does not write X", "b does not write X"),
        ("a task of play (a, b)", "puma", "play does not use puma"),
        ("a task that supplies the constant NDOF", "none", "no task gives the constant NDOF"),
        (
            "a task that gives the constant NDOF",
            "none for `a` (in `aC`, step 0) of flow 0",
            "no task gives the constant",
        ),
        ("only ports that module pd declares", "INVAR ODD", "module pd has no port INVAR ODD"),
        ("INVAR Q, as module pd declares", "no such port", "its task has no port INVAR Q, which module pd declares"),
        ("LOCAL BASE double[4]", "LOCAL BASE: expected 4 values, found 2", "LOCAL BASE: expected 4 values, found 2"),
        ("a task that writes X", "only `b`, reading it", "nobody writes X, read by b"),
        ("values for jtraj", "home: expected 6 doubles, found 5", "home does not suit jtraj: expected 6 doubles"),
        (
            "a condition on a variable that a task of flow1 has",
            "`Q > 1` at `a`, step 0 of flow 1",
            "the condition Q > 1 asks",
        ),
    ],
)
def test_a_fault_is_told_without_line_and_step(expected, found, words):  # R-E01, R-X01
    told = said(Fault(HERE, expected, found, "the application is not run"))
    assert told.startswith(words)
    assert "step " not in told and "`" not in told and "branch" not in told


def test_what_has_no_words_of_its_own_says_what_was_expected_and_what_happens_instead():
    assert said(Fault(HERE, "a sun", "rain", "it is wet", is_note=True)) == "expected a sun, found rain; it is wet"


def test_what_two_tasks_have_in_common_is_told_once():  # law 9
    who = "`a` (in `aC`) and `b` (in `bC`) of flow 0"
    faults = [Fault(HERE, "one supplier of each constant in a flow", f"{name} from {who}", "") for name in ("DH", "KP")]
    hole = Fault(HERE, "an application without holes", "a hole", "")
    joined, other = together([faults[0], hole, faults[1]])
    assert said(joined) == "a (in aC) and b (in bC) cannot live in one flow: both give DH, KP"
    assert other == hole
