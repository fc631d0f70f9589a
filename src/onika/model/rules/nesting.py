"""Finds the applications that run within another, and those that would run within themselves (requirement E06)."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from onika.model.application import Action, Application
from onika.model.rules.outline import Outline, Passage
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.reason import Reason

MOST = 100_000
"""Actions that an application may have together with all that are nested in it, each time they are."""

DEEPEST = 100
"""How many applications and branches may stand within each other."""

Use = tuple[Passage, Action]


@dataclass(slots=True)
class Nest:
    """An application with all that are nested in it, inner ones first, by name; `faults` are those of the nesting."""

    outlines: dict[str, Outline] = field(default_factory=dict)
    cuts: set[tuple[str, str]] = field(default_factory=set)
    """An application and one it runs, where that closes a circle."""
    faults: list[Fault] = field(default_factory=list)

    is_too_much: bool = False
    """Whether it is nested too often or too deep to be laid out in line."""

    @property
    def top(self) -> Outline:
        """The application itself."""
        return next(reversed(self.outlines.values()))

    def runs(self, outline: Outline, action: Action, syntax: Syntax) -> Outline | None:
        """The application that an action runs; None for other actions, and where it is missing or closes a circle."""
        name = action.icon.onikon.name
        is_cut = (outline.application.name, name) in self.cuts
        if is_cut or not _is_application(action, syntax):
            return None
        return self.outlines.get(name)


def nest(top: Outline, syntax: Syntax, applications: Mapping[str, Application], files: Mapping[str, str]) -> Nest:
    """Everything that `top` runs, as far as it is there; each application is looked at once.

    `files` gives the files of applications, for messages.
    """
    nest = Nest()
    path = [top]
    ways = [_uses(top, syntax)]
    while path:
        outer = path[-1]
        use = next(ways[-1], None)
        if use is None:
            nest.outlines[outer.application.name] = outer
            path.pop()
            ways.pop()
            continue
        name = use[1].icon.onikon.name
        names = [outline.application.name for outline in path]
        if name in names:
            nest.cuts.add((outer.application.name, name))
            nest.faults.append(_circle(outer, use, names[names.index(name) :]))
        elif name in applications and name not in nest.outlines:
            file = files.get(name, f"{name}.appl")
            path.append(Outline.of(applications[name], syntax, file, is_nested=True))
            ways.append(_uses(path[-1], syntax))
    too_much = list(_too_much(nest, syntax))
    nest.faults += too_much
    nest.is_too_much = bool(too_much)
    return nest


def missing(outline: Outline, syntax: Syntax, names: frozenset[str]) -> Iterator[Fault]:
    """The applications that an application runs and that are not `known`."""
    for passage, action in _uses(outline, syntax):
        name = action.icon.onikon.name
        if name not in names:
            at = outline.at(passage, action.position)
            yield outline.fault(action.icon, Reason.of("rules.application_missing", name=name, at=at))


def _uses(outline: Outline, syntax: Syntax) -> Iterator[Use]:
    return ((passage, action) for passage, action in outline.actions() if _is_application(action, syntax))


def _is_application(action: Action, syntax: Syntax) -> bool:
    kind = syntax.acting(action.icon.onikon.type)
    return kind is not None and kind.is_application


def _circle(outer: Outline, use: Use, names: list[str]) -> Fault:
    passage, action = use
    circle = Reason.plain(names[0])
    for name in names[1:]:
        circle = Reason.of("rules.inside", inner=name, outer=circle)
    circle = Reason.of("rules.inside", inner=names[0], outer=circle)
    at = outer.at(passage, action.position)
    return outer.fault(action.icon, Reason.of("rules.application_circle", circle=circle, at=at))


def _too_much(nest: Nest, syntax: Syntax) -> Iterator[Fault]:
    """What is nested so often or so deep that nobody can have meant it, and that no runtime could hold."""
    sizes: dict[str, int] = {}
    depths: dict[str, int] = {}
    for name, outline in nest.outlines.items():
        size, depth = 0, 1
        for passage, action in outline.actions():
            inner = nest.runs(outline, action, syntax)
            size += sizes[inner.application.name] if inner else 1
            branches = passage.path.count("branch")
            depth = max(depth, 1 + branches + (depths[inner.application.name] if inner else 0))
        sizes[name], depths[name] = min(size, MOST + 1), depth
    name = nest.top.application.name
    if sizes[name] > MOST:
        yield nest.top.fault(None, Reason.of("rules.actions_too_many", most=MOST))
    if depths[name] > DEEPEST:
        yield nest.top.fault(None, Reason.of("rules.nested_too_deep", most=DEEPEST, depth=depths[name]))
