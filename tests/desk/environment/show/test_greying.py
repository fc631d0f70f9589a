from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.show.greying import GreyedTasks
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.rules.placement import greyed
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import Library

VARS = ("A", "B", "C")
ports = st.lists(st.sampled_from(VARS), unique=True, max_size=2).map(tuple)
NAMES = tuple("stuvw")


def task(name):
    modules = st.sampled_from(["m", "n", "o", "p"])
    return st.builds(Task, st.just(name), modules, inconst=ports, outconst=ports, invar=ports, outvar=ports)


shelves = st.tuples(*(task(name) for name in NAMES)).map(
    lambda tasks: OpenLibraries((Library(BaseDirectory("x"), {task.name: RmodText(task) for task in tasks}, ()),))
)
several = st.tuples(st.permutations([*NAMES, "unknown"]), st.integers(0, 6)).map(
    lambda drawn: tuple(drawn[0][: drawn[1]])
)
placements = st.lists(several)


def plain(names, libraries):
    placed = [libraries.tasks[name] for name in names if name in libraries.tasks]
    grey = greyed(libraries.tasks.values(), placed)
    return {name: reasons(refused, "c1", libraries.tasks[name]) for name, refused in grey.items()}


@given(shelves, placements)
@settings(max_examples=examples(100), deadline=None)
def test_the_set_is_what_it_would_be_made_anew_whatever_comes_and_goes(libraries, placements):  # R-C07, Equation (2)
    greying = GreyedTasks("c1")
    for names in placements:
        assert greying.greyed(names, libraries) == plain(names, libraries)


@given(shelves, shelves, placements)
@settings(max_examples=examples(50), deadline=None)
def test_it_follows_changed_libraries(first, other, placements):  # R-C01, R-C07
    greying = GreyedTasks("c1")
    for names in placements:
        for libraries in (first, other):
            assert greying.greyed(names, libraries) == plain(names, libraries)


@given(shelves, st.permutations(NAMES))
@settings(max_examples=20, deadline=None)
def test_what_has_not_changed_is_the_same_object(libraries, names):
    greying = GreyedTasks("c1")
    first = greying.greyed(tuple(names), libraries)
    assert greying.greyed(tuple(names), libraries) is first
    fewer = greying.greyed(tuple(names[:-1]), libraries)
    untouched = {name for name in NAMES if names[-1] not in str(first.get(name))}
    assert all(fewer[name] is first[name] for name in untouched & first.keys() if fewer[name] == first[name])
