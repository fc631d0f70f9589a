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


@st.composite
def laboratories(draw: st.DrawFn) -> tuple[Application, Syntax, dict[str, Configuration], dict[str, Task]]:
    """An application of jobs, most of it in order."""
    syntax = draw(syntaxes())
    known = {task.name: task for task in draw(libraries(4, sparse=True))}
    for name in draw(st.lists(st.sampled_from(sorted(known)), max_size=1)) if known else ():
        known[name] = replace(known[name], object_type=draw(st.sampled_from(["Joint job", "cartesian job"])))
    names = st.lists(st.sampled_from([*sorted(known), *sorted(known), "gone"]), unique=True, max_size=2)
    found = {name: Configuration(name, tuple(Placed(task) for task in draw(names))) for name in "jk"}
    kinds = st.sampled_from([*JOBS, "Complete NOP", "Joint object", "Joint object", "Cartesian object"])
    flows = [draw(marked(draw(st.lists(kinds, min_size=1, max_size=4)))) for _ in range(draw(st.integers(1, 2)))]
    return Application("app", draw(st.booleans()), tuple(flows)), syntax, found, known
