"""What modules declare, asked of a runtime one by one in the background, so that no order ever waits for it."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.reconcile.task_plan import code_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.wire import live, request
from onika.wire.sheet import ModuleSheet
from onika.words.reason import Reason

_AT_ONCE = 16
"""Modules after which what was learnt is shown."""
_UNREADABLE = Reason.of("run.unreadable")


@dataclass(frozen=True, slots=True)
class LearntDescriptions:
    """What was told and is not shown yet."""

    sheets: Mapping[str, ModuleSheet] = field(default_factory=dict)
    unread: Mapping[str, Reason] = field(default_factory=dict)
    digests: Mapping[str, str] = field(default_factory=dict)

    @property
    def names(self) -> frozenset[str]:
        """The modules it is about."""
        return frozenset((*self.sheets, *self.unread))

    def taken_over(self, model: Model) -> Model:
        """The model with it."""
        if not self.names:
            return model
        libraries = model.libraries
        new = replace(
            libraries,
            sheets={**libraries.sheets, **self.sheets},
            unread={**libraries.unread, **self.unread},
            digests={**libraries.digests, **self.digests},
        )
        return replace(model, libraries=new)


def describe(model: Model, learnt: LearntDescriptions | None = None) -> Done:
    """Ask for the next module that nobody has described; nothing is left: show what was learnt."""
    learnt = learnt or LearntDescriptions()
    if len(learnt.names) >= _AT_ONCE:
        model, learnt = learnt.taken_over(model), LearntDescriptions()
    for module, task in _lacking(model.libraries, learnt):
        code = code_of(module, model.libraries, task)
        if isinstance(code, Reason):
            learnt = replace(learnt, unread={**learnt.unread, module: code})
            continue
        then = partial(_told, module=module, digest=code.digest, learnt=learnt)
        return Done(model, orders=(Order(live.Describe((code,)), then),))
    return Done(learnt.taken_over(model))


def forgotten(model: Model, module: str) -> Model:
    """Without what is known of a module, whose code has changed."""
    libraries = model.libraries
    if module not in libraries.sheets and module not in libraries.unread:
        return model
    sheets = {name: sheet for name, sheet in libraries.sheets.items() if name != module}
    unread = {name: reason for name, reason in libraries.unread.items() if name != module}
    digests = {name: digest for name, digest in libraries.digests.items() if name != module}
    return replace(model, libraries=replace(libraries, sheets=sheets, unread=unread, digests=digests))


def _told(model: Model, response: request.Response, module: str, digest: str, learnt: LearntDescriptions) -> Done:
    if not isinstance(response, live.Described):
        return Done(learnt.taken_over(model))  # the runtime is gone, or does not take code from here
    if digest in response.sheets:
        sheets = {**learnt.sheets, module: response.sheets[digest]}
        learnt = replace(learnt, sheets=sheets, digests={**learnt.digests, module: digest})
    else:
        why = response.faults.get(digest, _UNREADABLE)
        learnt = replace(learnt, unread={**learnt.unread, module: why})
    return describe(model, learnt)


def _lacking(libraries: OpenLibraries, learnt: LearntDescriptions) -> Iterator[tuple[str, str]]:
    """Modules that are not described, each with a task that uses it."""
    described = {*libraries.sheets, *libraries.unread, *learnt.names}
    for name, task in libraries.tasks.items():
        if task.module not in described:
            described.add(task.module)
            yield task.module, name
