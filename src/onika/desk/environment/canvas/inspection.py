"""Acts on what a running subsystem holds: values of modules by name, variables, memory, readings (A05, A12)."""

from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.watched_runs import is_on
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.desk.run.readings_text import HEADER, rows
from onika.desk.run.value_text import words
from onika.wire import act, live
from onika.wire.view import Remedy
from onika.words.reason import Reason


@on_document
def ask_module(model: Model, document: Document, command: act.AskModule, _outside: Services) -> No | Procedure:
    """What a module says of something by name; whoever watches may ask."""
    facts = _with_task(document, command.task)
    if isinstance(facts, No):
        return facts
    return _value(model, live.Get(facts.subsystem, command.task, command.name))


@on_document
def tell_module(model: Model, document: Document, command: act.TellModule, _outside: Services) -> No | Procedure:
    """Tell a module a value by name; only who holds the subsystem may."""
    facts = _with_task(document, command.task)
    if isinstance(facts, No):
        return facts
    if facts.is_foreign:
        return _foreign(document, facts)
    return _value(model, live.Set(facts.subsystem, command.task, command.name, command.value))


@on_document
def write_variable(model: Model, document: Document, command: act.WriteVariable, _outside: Services) -> No | Procedure:
    """Write a variable that no task writes; only who holds the subsystem may, and the runtime judges the value."""
    facts = _living(document)
    if isinstance(facts, No):
        return facts
    if facts.is_foreign:
        return _foreign(document, facts)
    return simply_done(model, live.Write(facts.subsystem, command.variable, command.values))


@on_document
def check_memory(model: Model, document: Document, _command: act.CheckMemory, _outside: Services) -> No | Procedure:
    """The value is what is unsound in the memory of variables; nothing where it is sound."""
    subsystem = readable_subsystem(model, document)
    if isinstance(subsystem, No):
        return subsystem
    return _findings(model, subsystem)


@on_document
def log_readings(model: Model, document: Document, _command: act.LogReadings, _outside: Services) -> No | Procedure:
    """The value is the text of a log: the present readings of all variables, exactly as they are."""
    subsystem = readable_subsystem(model, document)
    if isinstance(subsystem, No):
        return subsystem
    return _readings(model, subsystem)


def readable_subsystem(model: Model, document: Document) -> str | No:
    """The subsystem that a document is connected with, or that it looks into."""
    if document.watched is not None and is_on(model, document.watched):
        return document.watched.subsystem
    facts = _living(document)
    if isinstance(facts, No):
        return facts
    return facts.subsystem


def _value(model: Model, asked: live.Get | live.Set) -> Procedure:
    model, response = yield Ask(model, asked)
    if not isinstance(response, live.Value):
        return No(Reason.of("desk.module_refused", task=asked.task, why=refusal(response)))
    return Done(model, value="" if response.value is None else words(response.value))


def _findings(model: Model, subsystem: str) -> Procedure:
    model, response = yield Ask(model, live.Check(subsystem))
    if not isinstance(response, live.Findings):
        return No(refusal(response))
    return Done(model, value=response.findings)


def _readings(model: Model, subsystem: str) -> Procedure:
    model, response = yield Ask(model, live.Read(subsystem))
    if not isinstance(response, live.Values):
        return No(refusal(response))
    return Done(model, value=HEADER + "".join(row + "\n" for row in rows(subsystem, response)))


def _living(document: Document) -> SubsystemFacts | No:
    facts = document.live
    if facts is not None and facts.state == "live":
        return facts
    connect = Remedy(Reason.of("desk.connect_it"), act.Connect(document.id))
    return No(Reason.of("desk.not_connected", name=document.name), (connect,))


def _foreign(document: Document, facts: SubsystemFacts) -> No:
    reason = Reason.of("desk.held_by", name=facts.subsystem, holder=facts.holder)
    return No(reason, (Remedy(Reason.of("desk.take_it"), act.Take(document.id)),))


def _with_task(document: Document, task: str) -> SubsystemFacts | No:
    facts = _living(document)
    if isinstance(facts, No) or task in facts.tasks:
        return facts
    return No(Reason.of("desk.not_living", task=task))
