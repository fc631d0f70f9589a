from collections import namedtuple

from hypothesis import given, strategies as st

from onika.model.rules.agreement import claims, contested, declared, device_of, disagreements, rivals
from onika.model.task import LocalLine, Task
from onika.words.reason import Reason

Port = namedtuple("Port", "name shape unit")


def arm(name, device):
    return Task(name, name, local=(LocalLine("DEVICE", (device,)),))


def test_variables_are_told_by_their_aliases_and_so_are_their_dimensions():  # law 7, R-C04
    task = Task("a", "a", aliases=(("X", "Q"), ("N", "NDOF")))
    assert declared(task, [Port("X", "double[N,4]", "rad")]) == {"Q": "double[NDOF,4] in rad"}


def test_type_shape_and_unit_have_to_agree():  # law 7
    tasks = {"a": {"Q": "double[6] in rad", "X": "int in -"}, "b": {"Q": "double[4] in rad", "X": "int in -"}}
    result = contested(tasks)
    assert result == {"Q": {"a": "double[6] in rad", "b": "double[4] in rad"}}
    (refused,) = disagreements("a", "Q", result["Q"], ("a", "b"))
    assert str(refused.reason) == "takes Q for double[6] in rad, `b` for double[4] in rad"
    assert refused.remedies == (Reason.of("rules.alias", svar="Q"), Reason.of("rules.show", task="b"))


names = st.sampled_from("abcd")
kinds = st.dictionaries(st.sampled_from("XYZ"), st.sampled_from(("int", "double", "byte")))


@given(tasks=st.dictionaries(names, kinds), name=names)
def test_whoever_disagrees_in_anything_is_told_of_everybody(tasks, name):  # law 7
    result = contested(tasks)
    sentences = {
        (svar, other)
        for svar, users in result.items()
        if name in users
        for other in users
        if disagreements(name, svar, users, (other,))
    }
    assert sentences == {
        (svar, other)
        for svar, kind in tasks.get(name, {}).items()
        for other, theirs in tasks.items()
        if theirs.get(svar, kind) != kind
    }


def test_a_device_has_one_master():  # law 16
    first, second, third = arm("first", "boxes:left"), arm("second", "boxes:left"), arm("third", "boxes:right")
    assert rivals([first, second, third, Task("plain", "plain")]) == {"boxes:left": ("first", "second")}
    (refused,) = claims("second", "boxes:left", ("first", "second"))
    assert str(refused.reason) == "moves boxes:left, which `first` moves already"
    assert device_of(Task("odd", "odd", local=(LocalLine("DEVICE", ()),))) == ""
