"""What is known of living tasks, from what a runtime says there is."""

from collections.abc import Mapping
from dataclasses import replace

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import Base, Live, TaskFacts
from onika.wire import event, live


def alive(standing: live.Standing, subsystem: str) -> Mapping[str, live.TaskStanding]:
    """The living tasks of a subsystem, by name."""
    home = next((one for one in standing.subsystems if one.name == subsystem), None)
    return {one.task.name: one for one in home.tasks if one.state != "KILLED"} if home else {}


def with_standing(known: Live, standing: live.Standing) -> Live:
    """With the facts of a subsystem; what is about to be born is still so."""
    there = alive(standing, known.subsystem)
    home = next((one for one in standing.subsystems if one.name == known.subsystem), None)
    asks = {one.task: one for one in home.asks} if home else {}
    tasks = {name: _facts(one, known.tasks.get(name), asks.get(name)) for name, one in there.items()}
    if known.pending:
        tasks = {name: one for name, one in known.tasks.items() if one.state == "SPAWNING"} | {
            name: one for name, one in tasks.items() if known.state_of(name) != "SPAWNING"
        }
    return replace(known, tasks=tasks, holder=home.holder if home else "")


def settled(document: Document) -> Document:
    """Where nothing is under way, what is wanted is what there is: facts come first."""
    known = document.live
    if known is None or known.state != "live" or known.pending:
        return document
    content = true_to_facts(document.content, known, document.content)
    return replace(document, content=content, live=replace(known, base=Base(content, document.history)))


def true_to_facts(content: Content, known: Live, sent: Content) -> Content:
    """With what is wanted as it is, but where somebody has asked for something else since `sent`."""
    wanted = {
        name: _is_wanted(known.state_of(name), is_on) if sent.wanted.get(name) == is_on else is_on
        for name, is_on in content.wanted.items()
    }
    return content if wanted == content.wanted else replace(content, wanted=wanted)


def _facts(one: live.TaskStanding, former: TaskFacts | None, asked: event.Asked | None) -> TaskFacts:
    known = former or TaskFacts("")
    asked = asked or known.question
    is_asking = one.state == "ASKING"
    return TaskFacts(
        state=one.state,
        note="" if asked and is_asking else one.reason,
        rtpu=one.rtpu,
        hz=one.frequency,
        question=asked if is_asking else None,
        present=known.present if is_asking else {},
        failed=known.failed if one.state == "ERROR" else None,
        warnings=known.warnings,
    )


def _is_wanted(state: str, was_wanted: bool) -> bool:
    if state in ("ON", "ASKING"):
        return True
    return was_wanted and state in ("ERROR", "SPAWNING")
