"""What is known of living tasks, from what a runtime says there is."""

from collections.abc import Mapping
from dataclasses import replace

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import RequestedState, SubsystemFacts, TaskFacts
from onika.wire import event
from onika.wire.runtime_standing import Standing, TaskStanding
from onika.words.reason import NOTHING


def alive(standing: Standing, subsystem: str) -> Mapping[str, TaskStanding]:
    """The living tasks of a subsystem, by name."""
    home = next((candidate for candidate in standing.subsystems if candidate.name == subsystem), None)
    if home:
        return {task.task.name: task for task in home.tasks if task.state != "KILLED"}
    return {}


def with_standing(subsystem_facts: SubsystemFacts, standing: Standing) -> SubsystemFacts:
    """With the facts of a subsystem; what is about to be born is still so."""
    there = alive(standing, subsystem_facts.subsystem)
    home = next((subsystem for subsystem in standing.subsystems if subsystem.name == subsystem_facts.subsystem), None)
    asks = {ask.task: ask for ask in home.asks} if home else {}
    tasks = {
        name: _facts(task_standing, subsystem_facts.tasks.get(name), asks.get(name))
        for name, task_standing in there.items()
    }
    if subsystem_facts.pending:
        tasks = {name: task for name, task in subsystem_facts.tasks.items() if task.state == "SPAWNING"} | {
            name: task for name, task in tasks.items() if subsystem_facts.state_of(name) != "SPAWNING"
        }
    holder, recording = (home.holder, home.recording) if home else ("", "")
    return replace(subsystem_facts, tasks=tasks, holder=holder, recording=recording)


def settled(document: Document) -> Document:
    """Where nothing is under way, what is wanted is what there is: facts come first."""
    subsystem_facts = document.live
    if subsystem_facts is None or subsystem_facts.state != "live" or subsystem_facts.pending:
        return document
    content = true_to_facts(document.content, subsystem_facts, document.content)
    return replace(
        document, content=content, live=replace(subsystem_facts, base=RequestedState(content, document.history))
    )


def true_to_facts(content: Content, subsystem_facts: SubsystemFacts, sent: Content) -> Content:
    """With what is wanted as it is, but where somebody has asked for something else since `sent`."""
    wanted = {
        name: _is_wanted(subsystem_facts.state_of(name), is_on) if sent.wanted.get(name) == is_on else is_on
        for name, is_on in content.wanted.items()
    }
    if wanted == content.wanted:
        return content
    return replace(content, wanted=wanted)


def _facts(standing: TaskStanding, former: TaskFacts | None, question: event.Asked | None) -> TaskFacts:
    former_facts = former or TaskFacts("")
    question = question or former_facts.question
    is_asking = standing.state == "ASKING"
    return TaskFacts(
        state=standing.state,
        note=NOTHING if question and is_asking else standing.reason,
        rtpu=standing.rtpu,
        hz=standing.frequency,
        question=question if is_asking else None,
        present=former_facts.present if is_asking else {},
        failed=former_facts.failed if standing.state == "ERROR" else None,
        warnings=former_facts.warnings,
        planned=standing.task,
    )


def _is_wanted(state: str, was_wanted: bool) -> bool:
    if state in ("ON", "ASKING"):
        return True
    return was_wanted and state in ("ERROR", "SPAWNING")
