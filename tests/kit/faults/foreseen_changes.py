"""Changes that were foreseen, and those that sessions were told of: both by what they are about (X24)."""

from collections.abc import Iterable
from dataclasses import dataclass

from onika.wire import event
from onika.wire.foresight import Foresight

Changes = dict[tuple[str, str], list[tuple[str, float]]]
"""By kind and subject: the states in their order, each with its time in ms since the fault."""
_UNTOLD = ("GONE", "CUT", "pausing")


@dataclass(frozen=True)
class Change:
    """One thing that has changed, and when: what an effect foretells."""

    kind: str
    subject: str
    after: str
    at_ms: float


def foretold(foresight: Foresight) -> Changes:
    """What is foreseen to be told."""
    changes: Changes = {}
    for effect in foresight.effects:
        if effect.after not in _UNTOLD:
            changes.setdefault((effect.kind, effect.subject), []).append((effect.after, effect.within_ms))
    return changes


def gathered(told: Iterable[Change]) -> Changes:
    """What was told; a state that stays is told again, of a flow that stands and has a second error."""
    changes: Changes = {}
    for change in told:
        steps = changes.setdefault((change.kind, change.subject), [])
        if not steps or steps[-1][0] != change.after:
            steps.append((change.after, change.at_ms))
    return changes


def changes_of(message: event.Event, at_ms: float) -> Iterable[Change]:
    """What an event says has changed, if it is anything that can be foreseen."""
    match message:
        case event.TaskState():
            yield Change("task", f"{message.subsystem}/{message.task}", message.state, at_ms)
        case event.Drive():
            yield Change("drive", message.device, message.state, at_ms)
        case event.Moved() if message.state in ("stopped", "paused"):
            yield Change("flow", message.subsystem, message.state, at_ms)
        case event.Result():
            yield Change("run", "test", "completed" if message.completed else "aborted", at_ms)
        case event.Held() if not message.holder:
            yield Change("subsystem", message.subsystem, "", at_ms)
        case event.Lost():
            yield Change("unit", message.name, "LOST", at_ms)
        case event.Stopped():
            yield Change("runtime", "", "STOPPED", at_ms)
