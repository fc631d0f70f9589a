from dataclasses import replace

import pytest
from tests.model.rules.upper import MOVE, POSE, SYNTAX, THERE, VIA, conf, flow, icon, job, outline, texts

from onika.model.application import Icon
from onika.model.rules.job import faults, whole
from onika.model.task import Task

TWO = Task("path", "path", object_type="Joint job", more_targets=("cartesian OBJECT",))
ONE = replace(TWO, more_targets=())


def sentences(*icons: Icon, task: Task = TWO, unread: frozenset[str] = frozenset()) -> list[str]:
    result = {"via": conf("via", "path"), "move": conf("move", "path")}
    return texts(faults(outline(flow(*icons)), SYNTAX, result, {"path": task}, unread))


def test_a_job_has_the_type_and_the_further_targets_of_its_trigger() -> None:
    assert sentences(VIA, THERE, POSE) == []  # reading 36, R-D13
    assert sentences(MOVE, THERE) == [
        (
            "work.appl: expected a Joint job with Cartesian object, as its trigger `path` says"
            ", found Joint job for `move`, step 0 of flow 0"
        )
    ]
    assert sentences(VIA, THERE, POSE, task=ONE) == [
        "work.appl: expected a Joint job, as its trigger `path` says"
        ", found Joint job with Cartesian object for `via`, step 0 of flow 0"
    ]


def test_the_order_of_further_targets_counts() -> None:
    several = icon("via", "Joint job", "Cartesian object", "Joint object")
    task = replace(TWO, more_targets=("Joint object", "Cartesian object"))
    assert sentences(several, task=task) == [
        (
            "work.appl: expected a Joint job with Joint object and Cartesian object, as its trigger `path` says"
            ", found Joint job with Cartesian object and Joint object for `via`, step 0 of flow 0"
        )
    ]


def test_a_missing_configuration_is_named_unless_it_is_told_elsewhere() -> None:
    lost = job("lost", line=9)
    assert sentences(lost) == ["work.appl:9: expected the configuration lost, found none for `lost`, step 0 of flow 0"]
    assert sentences(lost, unread=frozenset({"lost"})) == []


@pytest.mark.parametrize("kind", ["Odd job", "Complete NOP", "Complete application"])
def test_types_that_are_unknown_and_what_is_no_job_are_not_judged(kind: str) -> None:
    assert sentences(icon("move", kind)) == []  # R-D16


def test_a_configuration_is_whole_or_every_fault_is_told_at_the_icon_that_uses_it() -> None:
    result = outline(flow(job("x", line=3)))
    use = (result, result.passages[0], 0)
    tasks = {name: Task(name, name, outvar=("Q",)) for name in "ab"}
    assert texts(whole(conf("x", "a", "b", "c"), tasks, frozenset(), use)) == [
        "work.appl:3: expected the task c, found none for `x`, step 0 of flow 0",
        (
            "work.appl:3: expected tasks that may stand together"
            ", found `b` in `x`, step 0 of flow 0: writes Q, which `a` already writes"
        ),
    ]
    assert texts(whole(conf("x"), tasks, frozenset(), use)) == [
        "work.appl:3: expected tasks, found none in `x`, step 0 of flow 0"
    ]
    assert texts(whole(conf("x", "c"), tasks, frozenset("c"), use)) == []
