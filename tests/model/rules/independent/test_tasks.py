"""Equations (2), (3), (5), (6), the matrix of pins and the union of a flow: ours and the naive reading agree."""

from itertools import product

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.rules import placement, union, warning
from onika.model.task import Task
from onika.words.fault import Place
from onika.words.reason import Reason

from . import tasks as naive
from .drawn import KINDS, libraries, made

PLACE = Place("x")
ENDS = [way + kind for way in ("IN", "OUT") for kind in KINDS]
PAIRS = list(product(ENDS, ENDS))

FLOW = Reason.of("rules.flow", number=0)


def agree(library: tuple[Task, ...], placed: tuple[Task, ...]) -> None:
    assert set(placement.greyed(library, placed)) == naive.greyed(library, placed)
    for task in library:
        assert {fault.reason.args["svar"] for fault in warning.self_fed(task, PLACE)} == naive.self_fed(task)
    assert {fault.reason.args["svar"] for fault in warning.hanging(library, PLACE)} == naive.hanging(library)
    keys = [fault.reason.key for fault in union.conflicts(library, FLOW, PLACE)]
    lasting = [key for key in keys if key != "rules.constant_missing"]
    assert (not lasting) == naive.union_is_free(library)


@given(libraries(), libraries(4))
@settings(max_examples=examples(100), deadline=None)
def test_any_library_beside_any_configuration_is_judged_alike(
    library: tuple[Task, ...], placed: tuple[Task, ...]
) -> None:
    agree(library, placed)  # R-C07, R-C08, readings 1, 5, 6


@given(libraries(4, sparse=True), libraries(3, sparse=True))
@settings(max_examples=examples(100), deadline=None)
def test_tasks_of_few_pins_are_judged_alike(library: tuple[Task, ...], placed: tuple[Task, ...]) -> None:
    agree(library, placed)  # R-C07, R-C08, readings 1, 5, 6


@pytest.mark.slow
@given(st.booleans().flatmap(lambda sparse: st.tuples(libraries(8, sparse=sparse), libraries(8, sparse=sparse))))
@settings(max_examples=examples(2500), deadline=None)
def test_thousands_of_libraries_are_judged_alike(both: tuple[tuple[Task, ...], tuple[Task, ...]]) -> None:
    agree(*both)  # R-C07, R-C08, readings 1, 5, 6


@pytest.mark.parametrize(("item", "other"), PAIRS)
def test_two_pins_of_one_variable_stand_together_as_the_matrix_says(item: str, other: str) -> None:
    first, second = pinned("first", item), pinned("second", other)  # reading 6
    assert (placement.refusals(first, [second]) == ()) == naive.may_meet(item, other)


@pytest.mark.parametrize(("item", "other"), PAIRS)
def test_an_alias_counts_as_the_name(item: str, other: str) -> None:
    first = pinned("first", item)  # R-C07
    second = pinned("second", other, "Q", aliases=(("Q", "P"),))
    assert (placement.refusals(first, [second]) == ()) == naive.may_meet(item, other)
    assert placement.refusals(first, [pinned("second", other, "P", aliases=(("P", "Q"),))]) == ()


def pinned(name: str, pin: str, svar: str = "P", aliases: tuple[tuple[str, str], ...] = ()) -> Task:
    way, kind = ("IN", pin[2:]) if pin.startswith("IN") else ("OUT", pin[3:])
    plain = made(name, {svar: kind} if way == "IN" else {}, {svar: kind} if way == "OUT" else {})
    return Task(plain.name, plain.module, "", aliases, plain.inconst, plain.outconst, plain.invar, plain.outvar)
