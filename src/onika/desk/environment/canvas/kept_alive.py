"""Several configurations are kept alive in one subsystem, and one act switches between them (requirement C32, §5.3.4).

The tasks of all of them live; those of the one that is shown may be ON, all others rest. A switch is one change of the
running system: what both have goes on untouched, what is no longer needed goes OFF, what is needed comes ON.
"""

from collections.abc import Sequence
from dataclasses import replace

from onika.desk.environment.canvas.task_commands import held_facts
from onika.desk.environment.file.configurations import read
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.merge import with_loci
from onika.desk.environment.state.content import Content, KeptConfiguration
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.model.rules.union import conflicts, tasks_of
from onika.wire import act
from onika.wire.view import Remedy, ShowLibraries
from onika.words.fault import Place
from onika.words.reason import Reason


@on_document
def keep_alive(model: Model, document: Document, command: act.KeepAlive, outside: Services) -> Done | No:
    """Bring the tasks of one more configuration to life, OFF, beside those that are there."""
    facts = held_facts(model, document)
    if isinstance(facts, No):
        return facts
    reading = read(command.path, outside)
    if isinstance(reading, No):
        return reading
    newcomer = KeptConfiguration(reading.opened.value, reading.opened, reading.base.path)
    content = document.content
    refused = _refusal(model, document, newcomer)
    if refused is not None:
        return refused
    wanted = {**dict.fromkeys(newcomer.names, False), **content.wanted}
    new = replace(content, wanted=wanted, kept=(*content.kept, newcomer))
    label = Reason.of("desk.keeping_alive", name=newcomer.name)
    return Done(model.with_document(document.having(new)), label, document.id)


@on_document
def switch_to(model: Model, document: Document, command: act.SwitchTo, _outside: Services) -> Done | No:
    """Have the tasks of a kept configuration ON and all others OFF, as one change; what was shown is kept."""
    facts = held_facts(model, document)
    if isinstance(facts, No):
        return facts
    content = document.content
    target = _kept(content, command.name)
    if target is None:
        return _not_kept(document, command.name)
    hindered = _hindered(document, facts, target)
    if hindered is not None:
        return hindered
    former = KeptConfiguration(content.configuration, document.opened, document.base)
    kept = tuple(former if other is target else other for other in content.kept)
    wanted = {name: name in target.names for name in content.union}
    resting = [name for name in target.names if facts.state_of(name) not in ("ON", "ASKING")]
    new = replace(
        document.having(Content(target.configuration, wanted, kept)),
        opened=target.opened,
        base=target.base,
        has_changed_on_disk=False,
        live=replace(facts, turns={**facts.turns, **dict.fromkeys(resting, "")}),
    )
    label = Reason.of("desk.switching_to", name=target.name, former=document.name)
    return Done(with_loci(model, new), label, document.id)


@on_document
def let_go(model: Model, document: Document, command: act.LetGo, _outside: Services) -> Done | No:
    """End the tasks of a kept configuration that no other one has."""
    facts = held_facts(model, document)
    if isinstance(facts, No):
        return facts
    content = document.content
    target = _kept(content, command.name)
    if target is None:
        return _not_kept(document, command.name)
    if target.is_unsaved and not command.discards:
        again = Remedy(Reason.of("run.discard"), act.LetGo(document.id, command.name, discards=True))
        switch = Remedy(Reason.of("desk.switch_to", name=target.name), act.SwitchTo(document.id, target.name))
        return No(Reason.of("run.is_not_saved", name=target.name), (switch, again))
    left = replace(content, kept=tuple(other for other in content.kept if other is not target))
    alive = set(left.union)
    new = replace(left, wanted={name: is_on for name, is_on in content.wanted.items() if name in alive})
    label = Reason.of("desk.letting_go", name=target.name)
    return Done(model.with_document(document.having(new)), label, document.id)


def _kept(content: Content, name: str) -> KeptConfiguration | None:
    return next((kept for kept in content.kept if kept.name == name), None)


def _not_kept(document: Document, name: str) -> No:
    names = tuple(kept.name for kept in document.content.kept)
    if names:
        return No(Reason.of("desk.not_kept", name=name, names=names))
    return No(Reason.of("desk.none_kept", name=name))


def _refusal(model: Model, document: Document, newcomer: KeptConfiguration) -> No | None:
    """Why a configuration cannot be kept beside the others, if so."""
    content = document.content
    if newcomer.name in (document.name, *(kept.name for kept in content.kept)):
        return No(Reason.of("desk.kept_already", name=newcomer.name))
    tasks = model.libraries.tasks
    missing = tuple(name for name in newcomer.names if name not in tasks)
    if missing:
        remedy = Remedy(Reason.of("desk.open_library"), show=ShowLibraries())
        return No(Reason.of("desk.kept_missing", name=newcomer.name, tasks=missing), (remedy,))
    configurations = [content.configuration, *(kept.configuration for kept in (*content.kept, newcomer))]
    subsystem = document.live.subsystem if document.live else document.name
    faults = conflicts(tasks_of(configurations, tasks), Reason.plain(subsystem), Place(newcomer.name))
    if faults:
        reasons = tuple(fault.reason for fault in faults)
        return No(Reason.of("desk.not_kept_beside", name=newcomer.name, reasons=reasons))
    return None


def _hindered(document: Document, facts: SubsystemFacts, target: KeptConfiguration) -> No | None:
    """Why its tasks cannot come ON now: one has failed, or waits for a constant."""
    broken = _in_state(facts, target.names, "ERROR")
    if broken:
        clear = Remedy(Reason.of("run.clear"), act.Clear(document.id, broken[0]))
        return No(Reason.of("desk.kept_failed", name=target.name, tasks=tuple(broken)), (clear,))
    waiting = _in_state(facts, target.names, "WAITING")
    if waiting:
        why = facts.tasks[waiting[0]].note or Reason.of("desk.waits_for_constant")
        return No(Reason.of("desk.on_before_supplied", name=waiting[0], why=why))
    return None


def _in_state(facts: SubsystemFacts, names: Sequence[str], state: str) -> list[str]:
    return [name for name in names if facts.state_of(name) == state]
