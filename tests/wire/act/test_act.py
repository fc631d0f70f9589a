from typing import get_args

import msgspec
import pytest

from onika.wire import act, page

EVERY = get_args(act.AnyAct)
WORDS = {
    "wish": "pause",
    "doc": "c1",
    "tasks": ("pd",),
    "x": 1,
    "y": 2,
    "is_shown": True,
    "is_on": True,
    "hz": 5.0,
    "edge": "left",
}
UPPER = {"steps": (1, 2), "step": 3, "after": 3, "test": 4, "anchor": 5, "conditions": ("X > 1",), "is_parallel": True}
TIMES = {"at_s": 1.0, "begin_s": 0.5, "end_s": 2.0}
LISTS = {"svars": ("Q",), "lines": (("SPEED", ("0.5",)),), "values": {"min_size": 64}, "kind": "rmod"}


def filled(kind):
    """An act with something in every field that it needs."""
    needed = [field for field in msgspec.structs.fields(kind) if field.required]
    given = {"local": (), **WORDS, **TIMES, **LISTS, **UPPER}
    if kind is act.MakeTarget:
        return act.MakeTarget("home", "Joint object", (("1", "2"),), "8" * 1024)
    if kind is act.Move:
        return act.Move("c1", {"pd": (1, 2)}, {"Q": (3, 4)})
    return kind(**{field.name: given.get(field.name, "word") for field in needed})


@pytest.mark.parametrize("kind", EVERY, ids=lambda kind: kind.__name__)
def test_an_act_travels_whole(kind):
    message = filled(kind)
    assert page.decode(msgspec.json.encode(page.Ordered(3, message))) == page.Ordered(3, message)


@pytest.mark.parametrize("kind", EVERY, ids=lambda kind: kind.__name__)
def test_a_field_that_no_act_has_is_refused(kind):
    body = msgspec.to_builtins(page.Ordered(3, filled(kind)))
    body["act"]["surprise"] = 1
    with pytest.raises(ValueError, match="surprise"):
        page.decode(msgspec.json.encode(body))


def test_no_act_is_left_out():
    named = {kind for kind in vars(act).values() if isinstance(kind, type) and issubclass(kind, act.Act)}
    assert named - {act.Act} == set(EVERY)
