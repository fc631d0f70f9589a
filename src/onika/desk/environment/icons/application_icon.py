"""The icon that an application would make for others (requirement D09, readings 31 and 34, §5.6.4)."""

from collections.abc import Iterator, Sequence

from onika.desk.environment.canvas.draft import Draft, former_of, namesakes, of_type
from onika.desk.environment.outcome.fault_text import said, simple
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.model.application import Icon, every_flow
from onika.model.rules import hole, shape
from onika.model.rules.iconify import ActionType, application_type
from onika.model.rules.outline import Outline
from onika.model.syntax import Syntax
from onika.store.base_directory import BaseDirectory
from onika.store.site import Site
from onika.wire import act
from onika.wire.view import Remedy, ShowSaveAs, ShowStep
from onika.words.fault import Refusal
from onika.words.reason import Reason

_MOST = 4
"""Buttons beside a refusal."""


def drafted(model: Model, opened: OpenApplication, site: Site) -> Draft | No:
    """The icon of an application that is saved; else all reasons why it makes none, with what could be done."""
    syntax = model.syntax
    if syntax is None:
        return No(Reason.of("desk.no_syntax"))
    if opened.opened is None or opened.base is None:
        return No(Reason.of("desk.icon_of_no_file", name=opened.name), (_elsewhere(),))
    if opened.is_dirty:
        reason = Reason.of("desk.icon_of_unsaved", name=opened.name)
        return No(reason, (Remedy(Reason.of("desk.save_it"), act.Save(opened.id)), _elsewhere()))
    kind = application_type(opened.application, syntax)
    if not isinstance(kind, ActionType):
        return No(_refused(opened, syntax, kind), tuple(_remedies(opened, syntax))[:_MOST])
    home = BaseDirectory(opened.base)
    former, taken = former_of(opened.name, home, syntax, "application")
    acting = syntax.acting(kind.type)
    return Draft(
        name=opened.name,
        home=home,
        kind=kind,
        edges=(acting.left_edge, acting.right_edge) if acting else (0, 0),
        warnings=(
            *((taken,) if taken else ()),
            *of_type(kind, syntax, former),
            *_filled(opened, syntax),
            *_within_itself(opened, syntax),
            *namesakes(opened.name, home, site),
        ),
        notes=(),
        source=home.application_file(opened.name),
        former=former,
        taken=taken,
    )


def _elsewhere() -> Remedy:
    return Remedy(Reason.of("desk.save_as"), show=ShowSaveAs())


def _refused(opened: OpenApplication, syntax: Syntax, refused: Sequence[Refusal]) -> Reason:
    """What is wrong with its steps, which comes first, in the words of the list beside it; then what its holes want."""
    wrong = [said(fault) for fault in shape.faults(Outline.of(opened.application, syntax, opened.name), syntax)]
    wanted = [simple(refusal.reason) for refusal in refused[len(wrong) :]]
    return Reason.of("desk.several_reasons", reasons=tuple(dict.fromkeys((*wrong, *wanted))))


def _remedies(opened: OpenApplication, syntax: Syntax) -> Iterator[Remedy]:
    """To its holes: first those where an action is missing, which no target can fill."""
    holes = sorted(
        hole.holes(Outline.of(opened.application, syntax, opened.name), syntax), key=lambda open_hole: open_hole.types
    )
    for open_hole in holes:
        step = open_hole.passage.flow.steps[open_hole.position]
        label = (
            Reason.of("desk.fill_hole_for", kind=a_kind(open_hole.types[0]))
            if open_hole.types
            else Reason.of("desk.fill_hole")
        )
        yield Remedy(label, show=ShowStep(step.number))


def _filled(opened: OpenApplication, syntax: Syntax) -> Iterator[Reason]:
    """That one target fills several holes (D09), which is worth knowing before."""
    outline = Outline.of(opened.application, syntax, opened.name)
    wanted = [kind for open_hole in hole.holes(outline, syntax) for kind in open_hole.types]
    for kind in hole.open_types(outline, syntax):
        count = sum(wanted_kind.lower() == kind.lower() for wanted_kind in wanted)
        if count > 1:
            yield Reason.of("desk.target_fills_holes", kind=kind_named(kind), count=count)


def _within_itself(opened: OpenApplication, syntax: Syntax) -> Iterator[Reason]:
    for _, flow in every_flow(opened.application):
        for step in flow.steps:
            kind = syntax.acting(step.onikon.type) if isinstance(step, Icon) else None
            if isinstance(step, Icon) and kind and kind.is_application and step.onikon.name == opened.name:
                yield Reason.of("desk.icon_within_itself", name=opened.name)
                return
