"""Steps that are repeated so many times: a job that counts behind them, its number, and the loop, as one step (D13)."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from onika.desk.environment.icons.action_of_step import StepAction, action_of, exchanged
from onika.desk.environment.icons.alteration import reflowed, spots_of
from onika.desk.environment.icons.fitting import misfit, onikons
from onika.desk.environment.icons.loops import crossing_refused, free_tag
from onika.desk.environment.outcome.on_file import on_resting_application, syntax_of
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.icon_words import for_placing
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import quoted
from onika.desk.plan.loop_counters import counts_loops
from onika.model.application import AppFlow, Icon
from onika.model.configuration import Configuration
from onika.model.initials import drawn
from onika.model.onikon import Onikon
from onika.model.rules import jigsaw
from onika.model.syntax import IconType
from onika.store.base_directory import BaseDirectory
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import Reason

_FEWEST, _MOST = 2, 1_000_000
_LETTERS = 2
"""As many signs a plain picture has."""


@on_resting_application
def repeat_steps(model: Model, opened: OpenApplication, command: act.RepeatSteps, _outside: Services) -> Done | No:
    """Have steps of one flow done so many times; the value is the tag of their loop."""
    if not _FEWEST <= command.times <= _MOST:
        unfit = Reason.of("desk.times_unfit", least=_FEWEST, most=_MOST, times=command.times)
        return No(unfit, fields={"times": unfit})
    counter = next(_counters(model, onikons(model)), None)
    if counter is None:
        return No(Reason.of("desk.no_counter"), tuple(_helping_dictionaries(model)))
    ends = _ends(model, opened, command)
    if isinstance(ends, No):
        return ends
    first, last = ends
    job, kind = counter
    flow, syntax = first.flow, syntax_of(model)
    refused = misfit(model, opened, flow, last, Icon(for_placing(job)), path=first.path)
    if refused:
        return refused
    number = _number(model, kind, command)
    tag = free_tag(opened.application)
    flow = jigsaw.insert(flow, last, Icon(for_placing(job), while_tag=tag, while_test=True), syntax)
    flow = jigsaw.insert(flow, last + 1, Icon(number), syntax)
    flow = _anchored(model, flow, first, tag)
    crossed = crossing_refused(opened, flow, tag, syntax)
    if crossed:
        return crossed
    label = Reason.of("desk.repeating", name=quoted(first.action.icon.onikon), times=command.times)
    return reflowed(model, opened, {first.path: flow}, label, tag)


def _ends(model: Model, opened: OpenApplication, command: act.RepeatSteps) -> tuple[StepAction, int] | No:
    """The action with which the steps begin, and the position of the last of them, with its targets."""
    spots = spots_of(opened.application, command.steps)
    if isinstance(spots, No):
        return spots
    if len({spot.path for spot in spots}) > 1:
        return No(Reason.of("desk.loop_over_flows"))
    spots = sorted(spots, key=lambda spot: spot.position)
    first = action_of(model, opened, spots[0].step.number)
    if isinstance(first, No):
        return first
    tag = first.action.icon.while_tag
    if tag is not None and _noop(model) is None:
        remove = Remedy(Reason.of("desk.remove_loop", tag=tag), act.RemoveLoop(opened.id, first.action.icon.number))
        return No(Reason.of("desk.in_a_loop_already", icon=quoted(first.action.icon.onikon), tag=tag), (remove,))
    last = action_of(model, opened, spots[-1].step.number)
    return first, spots[-1].position if isinstance(last, No) else last.action.end - 1


def _anchored(model: Model, flow: AppFlow, first: StepAction, tag: str) -> AppFlow:
    """With the anchor at the first action; at a no-op before it where that is an end of another loop already."""
    noop, icon = _noop(model), first.action.icon
    if icon.while_tag is None or noop is None:
        return exchanged(flow, {first.action.position: replace(icon, while_tag=tag, while_test=False, while_if="")})
    anchor = Icon(for_placing(noop), while_tag=tag, while_test=False)
    return jigsaw.insert(flow, first.action.position - 1, anchor, syntax_of(model))


def _noop(model: Model) -> Onikon | None:
    """A no-op of the open dictionaries, which takes no time and carries marks; None: there is none."""
    syntax = syntax_of(model)
    kinds = ((onikon, syntax.find(onikon.type)) for onikon in onikons(model))
    return next((onikon for onikon, kind in kinds if kind is not None and kind.is_noop), None)


def _helping_dictionaries(model: Model) -> Iterator[Remedy]:
    """To open one of the search path that has a job that counts."""
    opened, syntax = {dictionary.base.path for dictionary in model.dictionaries}, syntax_of(model)
    for base in (BaseDirectory(path) for path in model.search if path not in opened):
        icons = (base.onikon(name, syntax)[0] for name in base.onikons)
        if next(_counters(model, filter(None, icons)), None) is not None:
            label = Reason.of("desk.open_dictionary_named", name=base.path.name)
            yield Remedy(label, act.OpenDictionary(str(base.path)))


def _counters(model: Model, icons: Iterable[Onikon]) -> Iterator[tuple[Onikon, IconType]]:
    """The jobs among icons that only count how often a loop is done, with the type of the number."""
    configurations = {source.name: source for source in model.sources.values() if isinstance(source, Configuration)}
    syntax = syntax_of(model)
    for onikon in icons:
        configuration = configurations.get(onikon.name)
        kind = syntax.find(syntax.target_type_of(onikon.type) or "")
        takes_number = kind is not None and [(item.type.is_whole, item.count) for item in kind.items] == [(True, 1)]
        if configuration is None or kind is None or not takes_number:
            continue
        codes = [
            model.libraries.code_file(placed.task)
            for placed in configuration.placed
            if placed.task in model.libraries.tasks
        ]
        if codes and all(code is not None and counts_loops(code) for code in codes):
            yield onikon, kind


def _number(model: Model, kind: IconType, command: act.RepeatSteps) -> Onikon:
    """The target that says how often: that of a dictionary, else one of this application alone."""
    for onikon in onikons(model):
        if onikon.type == kind.name and onikon.values == ((command.times,),):
            return for_placing(onikon)
    digits = str(command.times)
    shown = "_".join(digits) if len(digits) <= _LETTERS else "x"
    description = " ".join(command.description.split()) or digits
    return Onikon(f"times_{digits}", kind.name, description, ((command.times,),), drawn(shown))
