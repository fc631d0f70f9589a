import pytest

from onika.model.configuration import Configuration, Placed
from onika.model.rules.redirection import candidates, is_alike, redirected, refusals, shortcomings
from onika.model.task import LocalLine, Task

DEVICE = (LocalLine("DEVICE", ("w:d",)),)
ROBOT = Task("robot", "robot", outconst=("N",), invar=("F",), outvar=("Q",), frequency=500.0, local=DEVICE)
PUSH = Task("push", "push", inconst=("N",), invar=("Q",), outvar=("F",), object_type="Joint job")
CREWS = {"go": (ROBOT, PUSH)}


def other(name="other", **changes):
    fields = {"outconst": ("N",), "invar": ("F",), "outvar": ("Q",), **changes}
    return Task(name, fields.pop("module", name), **fields)


def reasons(new, crews=CREWS, others=(), old=ROBOT):
    return [str(refusal.reason) for refusal in refusals(old, new, crews, others)]


@pytest.mark.parametrize(
    "new",
    [
        other(),
        other(outvar=("Q", "MORE")),
        other(aliases=(("WHERE", "Q"),), outvar=("WHERE",)),
        other(invar=("F", "Q")),
        other(invar=()),
        other(module="robot", local=DEVICE),
    ],
    ids=["same", "more", "aliased", "own output", "reads less", "same module and device"],
)
def test_a_task_with_the_same_outputs_or_more_may_stand_for_another(new):  # R-E09, reading 29
    assert reasons(new) == []
    assert is_alike(ROBOT, new)


@pytest.mark.parametrize(
    ("new", "reason"),
    [
        (other(outvar=()), "`other` does not write Q, as `robot` does"),
        (other(outconst=(), outvar=()), "`other` does not write N, Q, as `robot` does"),
        (other(object_type="Joint job"), "`other` takes the target of a Joint job, `robot` takes no target"),
        (other(invar=("F", "G")), "`other` reads G, which no task of `go` writes"),
        (other(inconst=("C",)), "`other` reads C, which no task of `go` writes"),
        (other(outvar=("Q", "F")), "writes F, which `push` already writes"),
        (other(module="push"), "its module `push` is used already, by `push`"),
        (PUSH, "`push` lives in this flow already"),
    ],
)
def test_what_speaks_against_it_is_told(new, reason):  # R-E09
    assert reason in reasons(new)


def test_all_reasons_are_told_at_once():  # R-E09
    result = reasons(other(outvar=("F",), invar=("G",), module="push"))
    assert len(result) == len(set(result)) == 4


def test_what_nobody_wrote_before_is_no_fault_of_the_redirection():  # R-X02
    assert reasons(other(invar=("G",)), {"alone": (ROBOT,)}) == []
    assert shortcomings(ROBOT, other(invar=("G",)), CREWS) != ()


def test_a_device_that_another_flow_claims_is_told():  # R-E09, law 16
    away = Task("away", "away", local=(LocalLine("DEVICE", ("w:e",)),))
    new = other(local=(LocalLine("DEVICE", ("w:e",)),))
    assert reasons(new, others=(away,)) == ["its device w:e is claimed by `away`"]
    assert reasons(new) == []


def test_candidates_come_first_then_those_that_are_near_with_their_reasons():  # R-E09
    existing = (ROBOT, PUSH, other("b"), other("a", outvar=("Q", "Z")), other("near", outvar=()), Task("far", "far"))
    result = candidates(ROBOT, existing, CREWS, ())
    assert [(item.task.name, bool(item.refusals), item.more) for item in result] == [
        ("a", False, ("Z",)),
        ("b", False, ()),
        ("near", True, ()),
    ]


def test_for_a_task_without_outputs_only_those_like_it_are_thought_of():  # R-E09
    mute = [Task(name, name, invar=("Q",)) for name in ("one", "two")]
    assert [candidate.task.name for candidate in candidates(mute[0], (*mute, ROBOT), {}, ())] == ["two"]


def test_a_rate_of_the_configurations_own_holds_for_whoever_stands_there():  # R-E09
    tasks = {item.name: item for item in (ROBOT, PUSH, other("new", frequency=250.0), other("odd"))}
    placed = Configuration("go", (Placed("robot", frequency=500.0, rtpu="rt1"), Placed("push", frequency=100.0)))
    assert redirected(placed, {"robot": "new"}, tasks).placed[0] == Placed("new", frequency=250.0, rtpu="rt1")
    assert redirected(placed, {"robot": "odd"}, tasks).placed[0].frequency == 0.0
    tuned = Configuration("go", (Placed("robot", frequency=400.0),))
    assert redirected(tuned, {"robot": "new"}, tasks).placed[0].frequency == 400.0
    assert redirected(placed, {"robot": "nobody"}, tasks) == placed
    assert redirected(placed, {"else": "new"}, tasks) is placed
