"""Which icons of the open dictionaries fit where another one does not, and buttons that take them (requirement X01)."""

from collections.abc import Iterator
from dataclasses import dataclass

from onika.desk.environment.icons.arm_fit import hardware_before, is_of_another_arm
from onika.desk.environment.outcome.on_file import syntax_of
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.icon_types import role_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import a_kind, named, quoted
from onika.model.application import AppFlow, Branch, Hole, Icon
from onika.model.flow_path import flows_by_path
from onika.model.onikon import Onikon
from onika.model.rules.gap import Solid, kind_at, kind_of
from onika.model.rules.jigsaw import fits, solid_at, stands_in_flow
from onika.model.syntax import IconType, Syntax
from onika.wire import act
from onika.wire.view import Remedy, ShowFits
from onika.words.reason import Reason

_MOST = 4
"""Buttons of a refusal."""


def onikons(model: Model) -> Iterator[Onikon]:
    """The icons of all open dictionaries."""
    for dictionary in model.dictionaries:
        yield from (opened.value for opened in dictionary.onikons.values())


def onikon(model: Model, name: str) -> Onikon | No:
    """The icon of this name."""
    onikon = next((onikon for onikon in onikons(model) if onikon.name == name), None)
    return onikon or No(Reason.of("desk.no_icon", name=name))


def misfit(model: Model, opened: OpenApplication, flow: AppFlow, after: int, step: Solid, *, path: str) -> No | None:
    """Why a step may not stand behind the step at `after` (-1: the start icon), with what could; None: it may.

    path    that of the flow, for the buttons
    """
    syntax = syntax_of(model)
    at = solid_at(flow, after)
    left, kind = kind_at(flow, at, syntax), kind_of(step, syntax)
    if isinstance(step, Icon) and (kind is None or not stands_in_flow(kind)):
        return No(Reason.of("desk.in_no_flow", icon=quoted(step.onikon), kind=a_kind(step.onikon.type)))
    if left is None or kind is None or fits(left, kind):
        return None
    before = flow.steps[at] if at >= 0 else None
    shown = Reason.of("desk.a_branch") if isinstance(step, Branch) else a_kind(kind.name)
    reason = Reason.of("desk.step_unfit", step=shown, behind=_place(before), needed=_needed(left, syntax, at))
    hardware = hardware_before(model, syntax, flow, at)
    return No(reason, tuple(_ways(model, opened, _Misfit(path, before, step, left, kind, hardware))))


@dataclass(frozen=True, slots=True)
class _Misfit:
    """A step that does not fit: the flow's path, the step before it, and the types on both sides.

    hardware    the tasks with a device of the job to which a target there would belong
    """

    path: str
    before: Solid | Hole | None
    step: Solid
    left: IconType
    kind: IconType
    hardware: tuple[str, ...]


def _place(before: Solid | Hole | None) -> Reason:
    """What a step would stand behind."""
    if isinstance(before, Icon):
        return quoted(before.onikon)
    if before:
        return Reason.of("desk.a_branch")
    return Reason.of("desk.the_start")


def _ways(model: Model, opened: OpenApplication, misfit: _Misfit) -> list[Remedy]:
    """What could be done instead: the last button, which shows all that fit, is always among them."""
    syntax, before, kind = syntax_of(model), misfit.before, misfit.kind
    number = before.number if before else 0
    fitting = fitting_behind(model, misfit.left, misfit.hardware)
    remedies = [*_in_its_place(model, opened, before, misfit.step, syntax)]
    remedies += _use(model, opened, misfit, number, _likeliest(model, fitting, kind, opened))
    if isinstance(before, Icon) and kind.is_target:
        remedies += _other_jobs(model, opened, before, kind, syntax)
    if fitting:
        remedies.append(Remedy(_show_fitting(len(fitting)), show=ShowFits(misfit.path, number)))
    if len(remedies) > _MOST:
        return remedies[: _MOST - 1] + remedies[-1:]
    return remedies


def _show_fitting(count: int) -> Reason:
    if count > 1:
        return Reason.of("desk.show_fitting", count=count)
    return Reason.of("desk.show_only_fitting")


def fitting_behind(model: Model, left: IconType, hardware: tuple[str, ...]) -> list[Onikon]:
    """The icons that fit behind one of this type, but for targets of other arms than those of these tasks."""
    syntax = syntax_of(model)
    own = (onikon for onikon in onikons(model) if not is_of_another_arm(onikon, hardware))
    kinds = ((onikon, syntax.acting(onikon.type)) for onikon in own)
    return [onikon for onikon, kind in kinds if kind and stands_in_flow(kind) and fits(left, kind)]


def _needed(left: IconType, syntax: Syntax, at: int) -> Reason:
    """What has to stand behind an icon of this type, as it stands there."""
    kinds = [kind.name for kind in syntax.types if kind.is_target and fits(left, kind)]
    if kinds:
        return Reason.of("desk.needs_kind", kinds=tuple(a_kind(kind) for kind in kinds))
    if at < 0:
        return Reason.of("desk.no_action_for_it")
    return Reason.of("desk.action_next")


def _in_its_place(
    model: Model, opened: OpenApplication, before: Solid | Hole | None, step: Solid, syntax: Syntax
) -> Iterator[Remedy]:
    """A new target that was put at another one of the same edges is most likely meant instead of it."""
    if not isinstance(before, Icon) or not isinstance(step, Icon) or step.number or before.onikon == step.onikon:
        return
    stands, new = kind_of(before, syntax), kind_of(step, syntax)
    if stands is None or new is None or not (stands.is_target and new.is_target):
        return
    is_like = (stands.left_edge, stands.right_edge) == (new.left_edge, new.right_edge)
    if is_like and isinstance(onikon(model, step.onikon.name), Onikon):
        label = Reason.of("desk.put_in_place", icon=named(before.onikon))
        yield Remedy(label, act.ExchangeIcon(opened.id, before.number, step.onikon.name))


def _likeliest(model: Model, fitting: list[Onikon], meant: IconType, opened: OpenApplication) -> list[Onikon]:
    """Those of the role of what was meant first, those behind which it would fit, those in use here, and their like."""
    syntax, role = syntax_of(model), role_of(meant)
    used = {
        step.onikon.name
        for _, flow in flows_by_path(opened.application)
        for step in flow.steps
        if isinstance(step, Icon)
    }

    dictionaries = [dictionary for dictionary in model.dictionaries if not used.isdisjoint(dictionary.onikons)]

    def rank(onikon: Onikon) -> tuple[bool, bool, bool, bool]:
        return (
            role_of(syntax.acting(onikon.type)) != role,
            not _leads_to(onikon, meant, syntax),
            onikon.name not in used,
            not any(onikon.name in dictionary.onikons for dictionary in dictionaries),
        )

    return sorted(fitting, key=rank)


def _use(
    model: Model, opened: OpenApplication, misfit: _Misfit, number: int, fitting: list[Onikon]
) -> Iterator[Remedy]:
    """Those that fit; behind one that leads to what was meant that comes too, where it is an icon of a dictionary."""
    step, syntax = misfit.step, syntax_of(model)
    is_new = isinstance(step, Icon) and not step.number
    meant = step.onikon.name if isinstance(step, Icon) and is_new else ""
    for other in fitting[:2]:
        if meant and _leads_to(other, misfit.kind, syntax) and isinstance(onikon(model, meant), Onikon):
            label = Reason.of("desk.first_insert", icon=named(other))
            yield Remedy(label, act.InsertIcon(opened.id, meant, misfit.path, number, first=other.name))
        else:
            label = Reason.of("desk.use_icon", icon=named(other))
            yield Remedy(label, act.InsertIcon(opened.id, other.name, misfit.path, number))


def _leads_to(onikon: Onikon, target: IconType, syntax: Syntax) -> bool:
    """Whether an icon is an action that takes this target."""
    kind = syntax.acting(onikon.type)
    return target.is_target and kind is not None and kind.needs_target and fits(kind, target)


def _other_jobs(
    model: Model, opened: OpenApplication, before: Icon, target: IconType, syntax: Syntax
) -> Iterator[Remedy]:
    """Jobs behind which the target would fit, in place of the one that stands there."""
    now = syntax.acting(before.onikon.type)
    if now is None or not now.needs_target:
        return
    for onikon in onikons(model):
        kind = syntax.acting(onikon.type)
        if kind and role_of(kind) == role_of(now) and kind.left_edge == now.left_edge and fits(kind, target):
            act_ = act.ExchangeIcon(opened.id, before.number, onikon.name)
            yield Remedy(Reason.of("desk.change_icon_to", before=named(before.onikon), after=named(onikon)), act_)
            return
