from functools import reduce

import msgspec

from onika.desk.environment.shared.grid import grid
from onika.desk.environment.shared.history import history, states


def put(tree, change):
    """A change of a place in the tree, as a page takes it over."""
    path, value = change
    tree = {**tree}
    if len(path) > 1:
        tree[path[0]] = put(tree.get(path[0], {}), (path[1:], value))
    elif value is None:
        tree.pop(path[0], None)
    else:
        tree[path[0]] = value
    return tree


def without_empty(value):
    """Maps that hold nothing say nothing."""
    if isinstance(value, dict):
        parts = {name: without_empty(part) for name, part in value.items()}
        return {name: part for name, part in parts.items() if part != {}}
    return value


def test_what_was_shown_comes_back_at_every_instant(watched):  # R-X21: 50 instants equal the recording
    instants = grid(watched.subject.view, 0.25)
    told = history(watched.subject, instants)
    for place, at in enumerate(instants.tolist()):
        changes = [change for number, parts in told["changes"] if number <= place for change in parts]
        expected = msgspec.to_builtins(watched.glance(at * 1e-9).run)
        del expected["recording"]
        assert without_empty(reduce(put, changes, told["first"])) == without_empty(expected)


def test_tasks_are_in_the_state_that_they_were_in(watched):  # R-X21
    instants = grid(watched.subject.view, 0.25)
    told = states(watched.subject, instants)
    for place, at in enumerate(instants.tolist()):
        expected = watched.glance(at * 1e-9).tasks
        assert {name: state for number, some in told if number <= place for name, state in some.items()} == expected


def test_where_it_was_recorded_is_not_told(watched):  # R-X21: nothing of the machine
    assert (
        str(watched.base.path)
        not in msgspec.json.encode(history(watched.subject, grid(watched.subject.view, 1))).decode()
    )
