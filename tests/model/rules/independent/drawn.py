"""Random tasks, syntaxes, flows and laboratories: small enough that they collide often."""

from collections.abc import Mapping
from dataclasses import replace

from hypothesis import strategies as st

from onika.model.application import AppFlow, Application, Hole, Icon, Step
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax
from onika.model.task import LocalLine, Task

from .onikons import Edges, Line

CODED = ("A", "B", "C", "D")
KINDS = ("CONST", "VAR", "BOTH")
PICTURE = blank()

_kinds = st.one_of(st.none(), st.none(), st.sampled_from(KINDS))
_aliases = st.dictionaries(st.sampled_from(CODED), st.sampled_from((*CODED, "X", "Y")), max_size=2)


def made(name: str, ins: Mapping[str, str], outs: Mapping[str, str], module: str = "", device: str = "") -> Task:
    """A task of these pins: coded name → CONST, VAR or BOTH."""
    return Task(
        name,
        module or f"of_{name}",
        inconst=tuple(svar for svar, kind in ins.items() if kind != "VAR"),
        invar=tuple(svar for svar, kind in ins.items() if kind != "CONST"),
        outconst=tuple(svar for svar, kind in outs.items() if kind != "VAR"),
        outvar=tuple(svar for svar, kind in outs.items() if kind != "CONST"),
        local=(LocalLine("DEVICE", (device, "fast")),) if device else (),
    )


@st.composite
def tasks(draw: st.DrawFn, name: str) -> Task:
    ins = {svar: kind for svar in CODED if (kind := draw(_kinds))}
    outs = {svar: kind for svar in CODED if (kind := draw(_kinds))}
    module = draw(st.sampled_from(["", "", "", "m", "n"]))
    device = draw(st.sampled_from(["", "", "", "w:arm", "w:grip"]))
    return replace(made(name, ins, outs, module, device), aliases=tuple(draw(_aliases).items()))


@st.composite
def sparse_tasks(draw: st.DrawFn, name: str) -> Task:
    """A task of few pins, so that many of them often live together."""
    pins = st.dictionaries(st.sampled_from((*CODED, "E", "F", "G")), st.sampled_from(KINDS), max_size=2)
    module = draw(st.sampled_from(["", "", "", "", "", "m"]))
    device = draw(st.sampled_from(["", "", "", "", "", "w:arm"]))
    return made(name, draw(pins), draw(pins), module, device)


@st.composite
def libraries(draw: st.DrawFn, most: int = 6, sparse: bool = False) -> tuple[Task, ...]:
    names = draw(st.lists(st.sampled_from("pqrstuvw"), unique=True, max_size=most))
    return tuple(draw((sparse_tasks if sparse else tasks)(name)) for name in names)


# -- the upper level

TYPES = (
    "Application start",
    "Application end",
    "Complete job",
    "Complete application",
    "Complete NOP",
    "Joint job",
    "Joint application",
    "Joint object",
    "Cartesian job",
    "Cartesian object",
)
UNKNOWN = ("Odd job", "Odd application")
JOBS = ("Complete job", "complete JOB", "Joint job", "Cartesian job", "Odd job")
PLACEABLE = (*TYPES[2:], *JOBS, *UNKNOWN, "joint object")


@st.composite
def syntaxes(draw: st.DrawFn) -> Syntax:
    edge = st.integers(0, draw(st.sampled_from([0, 1, 1, 2])))
    return Syntax(tuple(IconType(name, draw(edge), draw(edge)) for name in TYPES), ())


def edges_of(syntax: Syntax) -> Edges:
    return {kind.name.lower(): (kind.left_edge, kind.right_edge) for kind in syntax.types}


def icon(kind: str, name: str = "it") -> Icon:
    return Icon(Onikon(name, kind, "", (), PICTURE))


def flow(line: Line) -> AppFlow:
    return AppFlow(tuple(Hole() if kind is None else icon(kind) for kind in line))


def line(flow: AppFlow) -> Line:
    return [step.onikon.type if isinstance(step, Icon) else None for step in flow.steps]


lines: st.SearchStrategy[Line] = st.lists(st.one_of(st.sampled_from(PLACEABLE), st.none()), max_size=6)


@st.composite
def marked(draw: st.DrawFn, kinds: Line) -> AppFlow:
    """The flow of a line, some of its icons with loop tags."""
    steps: list[Step] = []
    for kind in kinds:
        if kind is None:
            steps.append(Hole())
            continue
        tag = draw(st.sampled_from([None, None, "a", "b"]))
        is_test = draw(st.booleans()) if tag else False
        steps.append(
            replace(icon(kind, draw(st.sampled_from(["j", "j", "k", "k", "lost"]))), while_tag=tag, while_test=is_test)
        )
    return AppFlow(tuple(steps))


# -- a laboratory with an application

CHUNKS: tuple[Line, ...] = (
    ["Complete job"],
    ["complete JOB"],
    ["Odd job"],
    ["Complete NOP"],
    ["Joint job", "Joint object"],
    ["Joint job", "joint object"],
)
STRANGE: tuple[Line, ...] = (["Joint job"], ["Joint object"], ["Cartesian job", "Joint object"], [None])


def rarely(usual: str, *strange: str) -> st.SearchStrategy[str]:
    return st.sampled_from([usual] * (8 * len(strange)) + list(strange))


@st.composite
def steps(draw: st.DrawFn) -> AppFlow:
    """A flow of jobs, most of it in order: j and k take no target, t takes one."""
    is_strange = draw(st.integers(0, 4)) == 0
    chunks = draw(st.lists(st.sampled_from(CHUNKS + STRANGE if is_strange else CHUNKS), min_size=1, max_size=4))
    marks = (
        draw(st.lists(st.sampled_from([None, None, "a", "b"]), min_size=8, max_size=8)) if is_strange else [None] * 8
    )
    tests = draw(st.lists(st.booleans(), min_size=8, max_size=8))
    if not is_strange and len(chunks) > 2 and draw(st.booleans()):
        starts = [sum(map(len, chunks[:number])) for number in range(len(chunks))]
        first, last = draw(st.lists(st.sampled_from(starts), unique=True, min_size=2, max_size=2))
        marks[first] = marks[last] = "a"
        tests[first], tests[last] = True, draw(st.integers(0, 2)) == 0
    steps: list[Step] = []
    for at, kind in enumerate(kind for chunk in chunks for kind in chunk):
        name = draw(rarely("t", "j", "lost") if kind in ("Joint job", "Cartesian job") else rarely("j", "k", "t"))
        shown = Hole() if kind is None else replace(icon(kind, name), while_tag=marks[at])
        steps.append(
            replace(shown, while_test=tests[at] and marks[at] is not None) if isinstance(shown, Icon) else shown
        )
    return AppFlow(tuple(steps))


@st.composite
def laboratories(draw: st.DrawFn) -> tuple[Application, Syntax, dict[str, Configuration], dict[str, Task]]:
    """An application of jobs, most of it in order."""
    syntax = draw(st.one_of(st.just(Syntax(tuple(IconType(name, 0, 0) for name in TYPES), ())), syntaxes()))
    existing = {task.name: task for task in draw(libraries(2, sparse=True))}
    for name in draw(st.sets(st.sampled_from("xyz"), max_size=2)):
        outs = dict.fromkeys(draw(st.lists(st.sampled_from("AB"), max_size=1)), "VAR")
        existing[name] = made(name, {}, outs)
    typed = draw(rarely("Joint job", "joint JOB", "Cartesian job", ""))
    trigger = made("typed", {}, draw(st.dictionaries(st.sampled_from("AB"), st.sampled_from(KINDS))))
    existing["typed"] = replace(trigger, object_type=typed or None)
    others = [name for name in existing if name != "typed"]
    names = st.lists(st.sampled_from(others), unique=True, max_size=2) if others else st.just([])
    members = {name: draw(names) for name in "jkt"}
    members["t"] += ["typed"]
    for name in draw(st.lists(st.sampled_from(["gone", "gone", "typed", *others]), max_size=1)):
        members[draw(st.sampled_from("jkt"))] += [name] * draw(st.sampled_from([0, 1]))
    result = {name: Configuration(name, tuple(map(Placed, dict.fromkeys(tasks)))) for name, tasks in members.items()}
    flows = [draw(steps()) for _ in range(draw(st.integers(1, 2)))]
    return Application("app", draw(st.booleans()), tuple(flows)), syntax, result, existing
