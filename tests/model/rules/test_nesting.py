from collections.abc import Mapping

from hypothesis import given, settings, strategies as st
from tests.model.rules.upper import SYNTAX, application, branch, flow, job, outline, part, texts
from tests.sentences import expected_by

from onika.model.application import Application
from onika.model.rules.nesting import DEEPEST, Nest, missing, nest


def made(runs: Mapping[str, tuple[str, ...]]) -> dict[str, Application]:
    """Applications that run each other; those that run nothing have a job."""
    return {
        name: application(flow(*(map(part, inner) if inner else [job()])), name=name) for name, inner in runs.items()
    }


def nested(runs: Mapping[str, tuple[str, ...]], first: tuple[str, ...] = ("a",)) -> Nest:
    return nest(outline(flow(*map(part, first))), SYNTAX, made(runs), {"a": "lab/appl/a.appl"})


def test_every_application_is_reached_once_inner_ones_first() -> None:
    found = nested({"a": ("b", "c"), "b": ("c",), "c": (), "unused": ()}, ("a", "c", "a"))  # R-E06
    assert list(found.outlines) == ["c", "b", "a", "work"]
    assert found.faults == []
    assert found.top.application.name == "work"
    assert [one.is_nested for one in found.outlines.values()] == [True, True, True, False]
    assert [one.file for one in found.outlines.values()] == ["c.appl", "b.appl", "lab/appl/a.appl", "work.appl"]


def test_a_circle_is_named_and_cut() -> None:
    found = nested({"a": ("b",), "b": ("c",), "c": ("a", "work")})  # R-E06
    assert texts(found.faults) == [
        "c.appl: no application within itself / a in c in b in a, at `a`, step 0 of flow 0 of `c`",
        "c.appl: no application within itself / work in c in b in a in work, at `work`, step 1 of flow 0 of `c`",
    ]
    assert found.cuts == {("c", "a"), ("c", "work")}
    passage, action = next(found.outlines["c"].actions())
    assert passage.path == "flow 0"
    assert found.runs(found.outlines["c"], action, SYNTAX) is None


def test_a_circle_through_a_branch_is_named() -> None:
    inner = application(flow(branch(flow(job()), flow(part("a")))), name="a")  # R-E06, R-D13
    found = nest(outline(flow(part("a"))), SYNTAX, {"a": inner}, {})
    assert texts(found.faults) == [
        "a.appl: no application within itself / a in a, at `a`, step 0 of flow 0, step 0, branch 1 of `a`"
    ]


def test_what_is_missing_is_named_at_every_icon() -> None:
    outer = outline(flow(part("a"), job(), part("lost", line=4)))
    assert texts(missing(outer, SYNTAX, frozenset({"a"}))) == [
        "work.appl:4: the application lost / none for `lost`, step 2 of flow 0"
    ]


def test_doubling_again_and_again_is_too_much() -> None:
    deep = {f"p{at}": (f"p{at + 1}",) * 2 for at in range(17)} | {"p17": ()}
    assert texts(nested(deep, ("p0",)).faults) == [
        "work.appl: at most 100000 actions, nested ones counted each time / more"
    ]
    assert not nested(deep, ("p1",)).is_too_much


def test_nesting_ends_somewhere() -> None:
    def chain(length: int) -> Nest:
        return nested({f"p{at}": (f"p{at + 1}",) for at in range(length)} | {f"p{length}": ()}, ("p0",))

    assert not chain(DEEPEST - 2).is_too_much
    (fault,) = chain(5000).faults
    assert expected_by(fault) == "at most 100 applications and branches within each other"


NAMES = "abcd"


@given(st.fixed_dictionaries({name: st.lists(st.sampled_from((*NAMES, "work")), max_size=3) for name in NAMES}))
@settings(max_examples=200, deadline=None)
def test_there_is_a_circle_exactly_if_an_application_reaches_itself(runs: dict[str, list[str]]) -> None:
    found = nested({name: tuple(inner) for name, inner in runs.items()})  # R-E06
    ways = {**runs, "work": ["a"]}

    def reached(start: str) -> set[str]:
        known: set[str] = set()
        waiting = list(ways[start])
        while waiting:
            name = waiting.pop()
            if name not in known:
                known.add(name)
                waiting += ways[name]
        return known

    own = reached("work") | {"work"}
    assert bool(found.cuts) == any(name in reached(name) for name in own)
    assert set(found.outlines) == own
    order = list(found.outlines)
    for outer in own:
        for inner in ways[outer]:
            assert (outer, inner) in found.cuts or order.index(inner) < order.index(outer)
