from hypothesis import given, strategies as st

from onika.model.configuration import Placed
from onika.model.rules import placement
from onika.model.rules.merge import merge
from onika.model.task import Task

TASKS = {
    item.name: item
    for item in (
        Task("move", "jtraj", outvar=("Q_REF",)),
        Task("draw", "ctraj", outvar=("Q_REF",)),
        Task("again", "jtraj", outvar=("X_REF",)),
        Task("arm", "puma", invar=("Q_REF",), outvar=("Q_MEZ",), outconst=("NDOF",)),
        Task("look", "viewer", invar=("Q_MEZ",), inconst=("NDOF",)),
        Task("lazy", "late", outvar=("NDOF",)),
    )
}
NAMES = st.lists(st.sampled_from(sorted(TASKS)), unique=True)


def at(name, **values):
    return Placed(name, **values)


def names(placed):
    return [item.task for item in placed]


def test_what_does_not_run_is_spawned_and_what_is_not_placed_comes_onto_the_canvas():  # R-C12, Equation (1)
    result = merge([at("move"), at("arm")], [at("look", rtpu="rt1")], TASKS)
    assert names(result.spawn) == ["move", "arm"]
    assert result.add == (at("look", rtpu="rt1"),)
    assert (result.remove, result.update) == ({}, ())


def test_a_placed_task_leaves_where_it_conflicts_with_a_running_one():  # R-C12, Equation (4)
    result = merge([at("move"), at("arm")], [at("draw")], TASKS)
    assert list(result.remove) == ["move"]
    assert "Q_REF" in str(result.remove["move"][0])
    assert names(result.placed) == ["arm", "draw"]


def test_one_module_twice_is_a_conflict_and_so_is_a_constant_given_too_late():  # R-C12, reading 3
    assert list(merge([at("again")], [at("move")], TASKS).remove) == ["again"]
    assert list(merge([at("look")], [at("lazy")], TASKS).remove) == ["look"]


def test_the_same_task_on_both_sides_takes_over_the_running_values_and_keeps_its_place():  # reading 4
    placed = at("move", x=40, y=7, frequency=100.0, rtpu="unknown", in_left=False)
    (item,) = merge([placed], [at("move", frequency=250.0, rtpu="rt1")], TASKS).update
    assert item == at("move", x=40, y=7, frequency=250.0, rtpu="rt1", in_left=False)


def test_a_task_that_runs_is_kept_though_it_conflicts_with_another_that_runs():  # Equation (4)
    result = merge([at("move")], [at("move"), at("again")], TASKS)
    assert result.remove == {}
    assert names(result.placed) == ["move", "again"]


def test_a_task_without_a_description_is_neither_spawned_nor_removed():  # reading 11
    result = merge([at("nobody"), at("arm")], [], TASKS)
    assert (names(result.spawn), result.remove) == (["arm"], {})


@given(NAMES, NAMES)
def test_the_sets_are_those_of_equations_1_and_4(placed, running):  # R-C12
    result = merge([at(name) for name in placed], [at(name, rtpu="rt0") for name in running], TASKS)
    conflicts = {
        placed
        for placed in placed
        if placed not in running
        for other in running
        if placement.refusals(TASKS[placed], [TASKS[other]])
    }
    assert set(result.remove) == conflicts
    assert set(names(result.add)) == set(running) - set(placed)
    assert set(names(result.spawn)) == set(placed) - set(running) - conflicts
    assert set(names(result.update)) == set(placed) & set(running)
    assert set(names(result.placed)) >= set(running)


@given(NAMES, NAMES)
def test_connecting_again_changes_nothing(placed, running):  # R-E10
    once = merge([at(name) for name in placed], [at(name) for name in running], TASKS)
    alive = [at(name) for name in (*running, *names(once.spawn))]
    again = merge(once.placed, alive, TASKS)
    assert (again.remove, again.add, again.spawn) == ({}, (), ())
