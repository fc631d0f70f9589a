"""Values of every format of Appendix A, each field of each drawn, and how they are written and read (R-B08)."""

import string
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from hypothesis import strategies as st
from tests.files import workcell_models

from onika.files import appl, buttons, conf, onk, picture, preferences, rmod, robot, syntax, world
from onika.files.rmod import RmodText
from onika.model.application import AppFlow, Application, Branch, Hole, Icon
from onika.model.button import Button
from onika.model.configuration import Configuration, Group, Locus, Placed
from onika.model.onikon import Onikon
from onika.model.own_lines import OwnLines
from onika.model.picture import SIZE, SIZES, Picture, framed
from onika.model.preferences import STATUS_COLUMNS, Preferences, Window, WindowCorner
from onika.model.syntax import SPECIAL_TYPES, DataItem, Edge, IconType, Syntax
from onika.model.task import LocalLine, Task, TaskType
from onika.words.fault import Fault
from onika.words.value import ValueType

TYPES = Syntax(
    types=(
        IconType("Application start", 0, 0),
        IconType("Application end", 0, 0),
        IconType("Complete job", 0, 0),
        IconType("Complete application", 0, 0),
        IconType("Complete NOP", 0, 0),
        IconType("Joint job", 0, 1),
        IconType("Joint application", 0, 1),
        IconType("Joint object", 1, 0, (DataItem("endpoint", ValueType.DOUBLE, 2), DataItem("who", ValueType.LINE, 1))),
        IconType("Any object", 1, 0, tuple(DataItem(kind.value, kind, 2) for kind in ValueType)),
    ),
    edges=(Edge(0, (1, 2, 3), ((-5, 5), (5, 5))), Edge(1, (255, 0, 0), ())),
)

# -- models

svar_names = st.from_regex(r"[A-Z][A-Z0-9_^]{0,5}", fullmatch=True).filter(lambda name: name != "NONE")
names = st.from_regex(r"[A-Za-z][A-Za-z0-9_.-]{0,8}", fullmatch=True)
prose = st.text(string.ascii_letters + '#=" éñ', max_size=20).map(lambda text: " ".join(text.split()))
some_prose = prose.filter(bool)
words = st.text(string.ascii_letters + string.digits + '#=".-+', min_size=1, max_size=8)
numbers = st.integers(-(10**6), 10**6)
counts = st.integers(0, 99)
sizes = st.integers(1, 9999)
rates = st.floats(1e-9, 1e9)
one_line_texts = st.text(st.characters(exclude_categories=("Cc", "Cs")), max_size=12)


def _picture(rows: list[str], size: int) -> Picture:
    """A picture of this size that repeats a few rows of 32 digits."""
    return framed([(row * 2)[:size] for row in (rows * size)[:size]])


pictures = st.builds(
    _picture,
    st.lists(st.text("012345678", min_size=SIZE, max_size=SIZE), min_size=3, max_size=3),
    st.sampled_from((SIZE, *SIZES)),
)
"""Mostly those of the thesis: what 1.3 can say is drawn as often."""


def more_targets(names: st.SearchStrategy[str]) -> st.SearchStrategy[tuple[str, ...]]:
    """Seldom any: what 1.3 can say is drawn as often."""
    return st.just(()) | st.lists(names, max_size=3).map(tuple)


descriptions = st.just(()) | st.dictionaries(st.sampled_from(["es", "de", "pt-BR"]), some_prose, max_size=2).map(
    lambda result: tuple(result.items())
)
"""In other languages; seldom any."""
relations = st.sampled_from(["==", "!=", "<", ">", "<=", ">="])
conditions = st.builds(
    lambda where, name, at, relation, number: f"{where}{name}{at} {relation} {number}",
    st.sampled_from(["", "", "flow0/"]),
    svar_names,
    st.sampled_from(["", "[0]", "[1,2]"]),
    relations,
    st.integers(-9, 9) | st.floats(-1e9, 1e9),
)


@st.composite
def tasks(draw: st.DrawFn) -> Task:
    coded = draw(st.lists(svar_names, unique=True, max_size=6))
    svars = draw(st.permutations(coded)) if draw(st.booleans()) else [name + "_A" for name in coded]
    aliases = [pair for pair in zip(coded, svars, strict=True) if draw(st.booleans())]
    resolved = [dict(aliases).get(name, name) for name in coded]
    outputs = [name for name, svar in zip(coded, resolved, strict=True) if resolved.count(svar) == 1]
    lists = [tuple(draw(st.lists(st.sampled_from(of), unique=True))) if of else () for of in (coded, outputs) * 2]
    present = {name for names in lists for name in names}
    kind = draw(st.sampled_from(TaskType))
    return Task(
        name="t",
        module=draw(names),
        description=draw(prose),
        aliases=tuple(pair for pair in aliases if pair[0] in present),
        inconst=lists[0],
        outconst=lists[1],
        invar=lists[2],
        outvar=lists[3],
        type=kind,
        frequency=None if kind is TaskType.APERIODIC else draw(rates),
        gives_period=kind is not TaskType.APERIODIC and draw(st.booleans()),
        object_type=(object_type := draw(st.none() | some_prose.map(lambda text: f"{text} job"))),
        more_targets=draw(more_targets(some_prose.map(lambda text: f"{text} object"))) if object_type else (),
        local=tuple(draw(st.lists(local_lines, unique_by=lambda line: line.key, max_size=4))),
    )


_local_keys = st.from_regex(r"[A-Za-z][A-Za-z0-9_^.-]{0,6}", fullmatch=True).filter(
    lambda key: key not in {slot.keyword for slot in rmod._SLOTS} | {"EOF"}
)

local_lines = st.builds(LocalLine, _local_keys, st.lists(words, max_size=3).map(tuple))


@st.composite
def own_lines(draw: st.DrawFn) -> OwnLines:
    """What a configuration says of a task, now and then: what 1.3 can say is drawn as often."""
    if draw(st.booleans()):
        return OwnLines()
    lines = draw(st.lists(local_lines, unique_by=lambda line: line.key, max_size=4))
    cut = draw(st.integers(0, len(lines)))
    aliases = draw(st.dictionaries(svar_names, svar_names, max_size=2))
    return OwnLines(tuple(aliases.items()), tuple(lines[:cut]), tuple(line.key for line in lines[cut:]))


@st.composite
def placed_tasks(draw: st.DrawFn) -> Placed:
    name, file = draw(names), draw(st.just("") | names)
    at, side, rate = draw(st.tuples(numbers, numbers)), draw(st.booleans()), draw(st.just(0.0) | rates)
    return Placed(name, *at, side, rate, draw(words), draw(own_lines()), "" if file == name else file)


groupless = st.builds(
    Configuration,
    st.just("c"),
    st.lists(
        placed_tasks(),
        unique_by=lambda placed: placed.task,
        max_size=3,
    ).map(tuple),
    st.lists(
        st.builds(Locus, svar_names, numbers, numbers, counts, counts, counts, counts, counts, counts, st.booleans()),
        unique_by=lambda locus: locus.svar,
        max_size=3,
    ).map(tuple),
)


@st.composite
def configurations(draw: st.DrawFn) -> Configuration:
    """Groups now and then: what 1.3 can say is drawn as often."""
    result = draw(groupless)
    tasks = [item.task for item in result.placed]
    if not tasks or draw(st.booleans()):
        return result
    chosen = draw(st.permutations(tasks))
    cuts = sorted(draw(st.sets(st.integers(1, len(chosen)), min_size=1)))
    named = draw(st.lists(names, min_size=len(cuts), max_size=len(cuts), unique=True))
    parts = [tuple(chosen[start:end]) for start, end in zip([0, *cuts], cuts, strict=False)]
    return replace(result, groups=tuple(map(Group, named, parts)))


def element(kind: ValueType) -> st.SearchStrategy[Any]:
    if kind.is_text:
        return one_line_texts
    if kind is ValueType.CHAR:
        return st.characters(max_codepoint=255, exclude_categories=("Cc",))
    if kind.is_real:
        return st.floats(allow_nan=False, allow_infinity=False)
    low, high = map(int, kind.bounds)
    return st.integers(low, high)


def values(kind: IconType) -> st.SearchStrategy[Any]:
    return st.tuples(*(st.tuples(*(element(item.type),) * item.count) for item in kind.items))


def onikons_of(kind: IconType) -> st.SearchStrategy[Onikon]:
    more = more_targets(st.sampled_from(["Joint object", "Any object"])) if kind.needs_target else st.just(())
    arms = st.just("") | names if kind.is_target else st.just("")
    return st.builds(Onikon, names, st.just(kind.name), prose, values(kind), pictures, more, descriptions, arms)


placeable = [kind for kind in TYPES.types if not (kind.is_start or kind.is_end)]
onikons = st.sampled_from(placeable).flatmap(onikons_of)


@st.composite
def icons(draw: st.DrawFn) -> Icon:
    tag = draw(st.none() | words)
    onikon = draw(onikons)
    if TYPES.find(onikon.type) in TYPES.types[-2:]:
        return Icon(onikon)  # marks live on the action (reading 24)
    marks = draw(st.booleans()), draw(st.none() | words), tag, tag is not None and draw(st.booleans())
    conditions_ = st.just("") | conditions
    return Icon(onikon, *marks, draw(conditions_), draw(conditions_) if tag is not None else "")


def _without_twin_holes(steps: list[Any]) -> AppFlow:
    kept = [step for at, step in enumerate(steps) if not (step == Hole() and at and steps[at - 1] == Hole())]
    return AppFlow(tuple(kept))


@st.composite
def branches(draw: st.DrawFn, inner: st.SearchStrategy[AppFlow]) -> Branch:
    chosen = draw(st.just([]) | st.lists(conditions, max_size=2))
    flows = [draw(inner) for _ in chosen] + draw(st.lists(inner, min_size=1, max_size=1 if chosen else 3))
    return Branch(tuple(flows), tuple(chosen))


def _flows(steps: st.SearchStrategy[Any]) -> st.SearchStrategy[AppFlow]:
    return st.lists(st.just(Hole()) | icons() | steps, max_size=3).map(_without_twin_holes)


flows = _flows(icons()) | st.recursive(_flows(icons()), lambda inner: _flows(branches(inner)), max_leaves=4)
applications = st.builds(Application, st.just("a"), st.booleans(), st.lists(flows, min_size=1, max_size=2).map(tuple))

spots = st.builds(WindowCorner, numbers, numbers)
windows = st.builds(Window, numbers, numbers, sizes, sizes)
columns = st.lists(st.sampled_from(STATUS_COLUMNS), unique=True).map(tuple)
all_preferences = st.builds(
    Preferences,
    *(sizes,) * 6,
    *(st.booleans(),) * 4,
    *(sizes,) * 2,
    st.booleans(),
    *(windows, windows, spots, spots, windows, windows, spots, spots),
    columns,
)
commands = st.text(string.ascii_letters + "#=\"' \t", min_size=1).map(lambda text: text.strip()).filter(bool)
all_buttons = st.lists(st.builds(Button, some_prose, commands, st.booleans()), max_size=3).map(tuple)


@st.composite
def syntaxes(draw: st.DrawFn) -> Syntax:
    numbers_ = draw(st.lists(st.integers(0, 20), unique=True, min_size=1, max_size=4))
    edge_numbers = st.sampled_from(numbers_)
    moves = st.lists(st.tuples(st.integers(-20, 20), st.integers(-20, 20)), max_size=3).map(tuple)
    colours = st.tuples(*(st.integers(0, 255),) * 3)
    dimensions = st.just("") | svar_names
    items = st.lists(
        st.builds(DataItem, some_prose, st.sampled_from(ValueType), st.integers(1, 9), dimensions, st.integers(1, 9)),
        max_size=3,
    ).map(lambda made: [item if item.dimension else replace(item, each=1) for item in made])
    types = [IconType(name, draw(edge_numbers), draw(edge_numbers)) for name in SPECIAL_TYPES]
    for at in range(draw(st.integers(0, 3))):
        word = draw(st.sampled_from(["job", "Application", "OBJECT", "thing"]))
        of = tuple(draw(items)) if word == "OBJECT" else ()
        types.append(IconType(f"x{at} {word}", draw(edge_numbers), draw(edge_numbers), of))
    return Syntax(tuple(types), tuple(Edge(number, draw(colours), draw(moves)) for number in numbers_))


# -- formats


@dataclass(frozen=True)
class Format:
    name: str
    ending: str
    models: st.SearchStrategy[Any]
    write: Callable[[Any], str]
    read: Callable[[str], tuple[Any, tuple[Fault, ...]]]
    is_extended: bool = False
    """Whether it has lines of version 2.0."""
    is_ours: bool = False
    """Whether it has no other lines: it is no format of Appendix A."""


def _read_task(text: str) -> tuple[Any, tuple[Fault, ...]]:
    record, faults = rmod.read(text, "t", "f")
    return record and (record.task, record.task.gives_period), faults


FORMATS = [
    Format(
        "task",
        rmod.ENDING,
        tasks().map(lambda task: (task, task.gives_period)),
        lambda pair: rmod.write(RmodText(pair[0])),
        _read_task,
    ),
    Format("configuration", conf.ENDING, configurations(), conf.write, lambda text: conf.read(text, "c", "f"), True),
    Format(
        "onikon",
        onk.ENDING,
        onikons.map(lambda onikon: replace(onikon, name="o")),
        onk.write,
        lambda text: onk.read(text, "o", "f", TYPES),
        is_extended=True,
    ),
    Format("application", appl.ENDING, applications, appl.write, lambda text: appl.read(text, "a", "f", TYPES), True),
    Format("syntax", "OnikaUpperSetUp.dta", syntaxes(), syntax.write, lambda text: syntax.read(text, "s", "f"), True),
    Format("preferences", ".onika", all_preferences, preferences.write, lambda text: preferences.read(text, "p", "f")),
    Format("buttons", ".onika.buttons", all_buttons, buttons.write, lambda text: buttons.read(text, "b", "f")),
    Format("picture", "picture.dta", pictures, picture.write, lambda text: picture.read(text, "p", "f")),
    Format(
        "robot",
        robot.ENDING,
        workcell_models.robots(),
        robot.write,
        lambda text: robot.read(text, "r", "f"),
        True,
        True,
    ),
    Format(
        "world",
        world.ENDING,
        workcell_models.worlds(),
        world.write,
        lambda text: world.read(text, "w", "f"),
        True,
        True,
    ),
]
