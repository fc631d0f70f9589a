"""Shows as a table where every flow is and what it waits for (requirements E11, X03)."""

from collections.abc import Sequence

from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run import text_table
from onika.wire.steer import Position


def lines(positions: Sequence[Position], flow_index: FlowIndex) -> list[str]:
    """A table: flow, state, action as people count them, and what there is to say besides."""
    rows = [
        [position.subsystem, state(position), _action(position, flow_index), remark(position)] for position in positions
    ]
    return text_table.lines(["flow", "state", "action", ""], rows)


def state(position: Position) -> str:
    """Its state in a word or two."""
    return f"{position.state}, will pause" if position.is_pausing and position.state != "paused" else position.state


def remark(position: Position) -> str:
    """Whom it waits for, which loops it is in, what has failed, where it would pause."""
    parts = []
    if position.state in ("waiting", "joining"):
        parts.append(waits(position.tag, position.waits_for))
    if position.loops:
        parts.append(f"in loop {' in '.join(reversed(position.loops))}")
    if position.failed:
        parts.append(f"failed: {', '.join(position.failed)}")
    if position.breakpoints:
        parts.append(f"pauses after {', '.join(str(at + 1) for at in position.breakpoints)}")
    return "; ".join(parts)


def waits(tag: str, waits_for: Sequence[str]) -> str:
    """What a flow waits for, in words; of a tag the word that stands in the file."""
    at = f" at {tag.rpartition(' ')[2]}" if tag else ""
    return f"waits{at}" + (f" for {' and '.join(waits_for)}" if waits_for else "")


def _action(position: Position, flow_index: FlowIndex) -> str:
    if position.action < 0:
        return "-"
    count, name = flow_index.count(position.subsystem), flow_index.name(position.subsystem, position.action)
    return f"{position.action + 1}" + (f"/{count}" if count else "") + (f" {name}" if name else "")
