from collections.abc import Mapping

from hypothesis import given, settings, strategies as st
from tests.model.rules.upper import SYNTAX, application, branch, flow, job, outline, part, texts

from kit.examples import examples
from onika.model.application import Application
from onika.model.rules.nesting import DEEPEST, Nest, missing, nest
from onika.words.reason import Reason


def made(runs: Mapping[str, tuple[str, ...]]) -> dict[str, Application]:
    """Applications that run each other; those that run nothing have a job."""
    return {
        name: application(flow(*(map(part, inner) if inner else [job()])), name=name) for name, inner in runs.items()
    }


def nested(runs: Mapping[str, tuple[str, ...]], first: tuple[str, ...] = ("a",)) -> Nest:
    return nest(outline(flow(*map(part, first))), SYNTAX, made(runs), {"a": "lab/appl/a.appl"})


def test_every_application_is_reached_once_inner_ones_first() -> None:
    result = nested({"a": ("b", "c"), "b": ("c",), "c": (), "unused": ()}, ("a", "c", "a"))  # R-E06
    assert list(result.outlines) == ["c", "b", "a", "work"]
    assert result.faults == []
    assert result.top.application.name == "work"
    assert [item.is_nested for item in result.outlines.values()] == [True, True, True, False]
    assert [item.file for item in result.outlines.values()] == ["c.appl", "b.appl", "lab/appl/a.appl", "work.appl"]


def test_a_circle_is_named_and_cut() -> None:
    result = nested({"a": ("b",), "b": ("c",), "c": ("a", "work")})  # R-E06
    assert texts(result.faults) == [
        "c.appl: expected no application within itself, found a in c in b in a, at `a`, step 0 of flow 0 of `c`",
        (
            "c.appl: expected no application within itself"
            ", found work in c in b in a in work, at `work`, step 1 of flow 0 of `c`"
        ),
    ]
    assert result.cuts == {("c", "a"), ("c", "work")}
    passage, action = next(result.outlines["c"].actions())
    assert passage.path == "flow 0"
    assert result.runs(result.outlines["c"], action, SYNTAX) is None


def test_a_circle_through_a_branch_is_named() -> None:
    inner = application(flow(branch(flow(job()), flow(part("a")))), name="a")  # R-E06, R-D13
    result = nest(outline(flow(part("a"))), SYNTAX, {"a": inner}, {})
    assert texts(result.faults) == [
        (
            "a.appl: expected no application within itself"
            ", found a in a, at `a`, step 0 of flow 0, step 0, branch 1 of `a`"
        )
    ]


def test_what_is_missing_is_named_at_every_icon() -> None:
    outer = outline(flow(part("a"), job(), part("lost", line=4)))
    assert texts(missing(outer, SYNTAX, frozenset({"a"}))) == [
        "work.appl:4: expected the application lost, found none for `lost`, step 2 of flow 0"
    ]


def test_doubling_again_and_again_is_too_much() -> None:
    deep = {f"p{at}": (f"p{at + 1}",) * 2 for at in range(17)} | {"p17": ()}
    assert texts(nested(deep, ("p0",)).faults) == [
        "work.appl: expected at most 100000 actions, nested ones counted each time, found more"
    ]
    assert not nested(deep, ("p1",)).is_too_much


def test_nesting_ends_somewhere() -> None:
    def chain(length: int) -> Nest:
        return nested({f"p{at}": (f"p{at + 1}",) for at in range(length)} | {f"p{length}": ()}, ("p0",))

    assert not chain(DEEPEST - 2).is_too_much
    (fault,) = chain(5000).faults
    assert fault.reason == Reason.of("rules.nested_too_deep", most=100, depth=5002)


NAMES = "abcd"


@given(st.fixed_dictionaries({name: st.lists(st.sampled_from((*NAMES, "work")), max_size=3) for name in NAMES}))
@settings(max_examples=examples(200), deadline=None)
def test_there_is_a_circle_exactly_if_an_application_reaches_itself(runs: dict[str, list[str]]) -> None:
    result = nested({name: tuple(inner) for name, inner in runs.items()})  # R-E06
    ways = {**runs, "work": ["a"]}

    def reached(start: str) -> set[str]:
        existing: set[str] = set()
        waiting = list(ways[start])
        while waiting:
            name = waiting.pop()
            if name not in existing:
                existing.add(name)
                waiting += ways[name]
        return existing

    own = reached("work") | {"work"}
    assert bool(result.cuts) == any(name in reached(name) for name in own)
    assert set(result.outlines) == own
    order = list(result.outlines)
    for outer in own:
        for inner in ways[outer]:
            assert (outer, inner) in result.cuts or order.index(inner) < order.index(outer)
