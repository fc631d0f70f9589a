"""A small upper level for the tests of rules: a syntax, icons in one word each, and outlines of flows."""

from onika.model.application import AppFlow, Application, Branch, Hole, Icon, Step
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.outline import Outline
from onika.model.syntax import IconType, Syntax
from onika.words.fault import Fault

KINDS = {
    "Application start": (0, 1),
    "Application end": (1, 0),
    "Complete job": (1, 1),
    "Complete application": (1, 1),
    "Complete NOP": (1, 1),
    "Joint job": (1, 2),
    "Joint application": (1, 2),
    "Joint object": (2, 1),
    "Cartesian job": (1, 3),
    "Cartesian application": (1, 3),
    "Cartesian object": (3, 1),
}
SYNTAX = Syntax(tuple(IconType(name, *edges) for name, edges in KINDS.items()), ())
PICTURE = blank()


def icon(name: str, kind: str, *more: str, **marks: object) -> Icon:
    return Icon(Onikon(name, kind, "", (), PICTURE, more), **marks)  # type: ignore[arg-type]


def job(name: str = "j", **marks: object) -> Icon:
    return icon(name, "Complete job", **marks)


def nop(**marks: object) -> Icon:
    return icon("nop", "Complete NOP", **marks)


def part(name: str = "part", kind: str = "Complete", *more: str, **marks: object) -> Icon:
    return icon(name, f"{kind} application", *more, **marks)


MOVE, REACH = icon("move", "Joint job"), icon("reach", "Cartesian job")
VIA = icon("via", "Joint job", "Cartesian object")
"""A job with two targets."""
THERE, POSE = icon("there", "Joint object"), icon("pose", "Cartesian object")
HOLE = Hole()


def flow(*steps: Step) -> AppFlow:
    return AppFlow(steps)


def branch(*flows: AppFlow, conditions: tuple[str, ...] = ()) -> Branch:
    return Branch(flows, conditions)


def application(*flows: AppFlow, name: str = "work", is_parallel: bool = False) -> Application:
    return Application(name, is_parallel, flows)


def outline(*flows: AppFlow, name: str = "work", is_parallel: bool = False, is_nested: bool = False) -> Outline:
    whole = application(*flows, name=name, is_parallel=is_parallel)
    return Outline.of(whole, SYNTAX, f"{name}.appl", is_nested=is_nested)


def conf(name: str, *tasks: str) -> Configuration:
    return Configuration(name, tuple(map(Placed, tasks)))


def texts(faults: object) -> list[str]:
    """Faults as `PLACE: reason`, notes with a star before them."""
    return [
        f"{'*' * fault.is_note}{fault.place}: {fault.reason}"
        for fault in faults  # type: ignore[attr-defined]
        if isinstance(fault, Fault)
    ]
