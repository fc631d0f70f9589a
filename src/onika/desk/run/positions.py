"""Shows as a table where every flow is and what it waits for (requirements E11, X03)."""

from collections.abc import Callable, Sequence

from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run import text_table
from onika.desk.run.text_table import Cell
from onika.wire.steer import Position
from onika.words.reason import Reason

_STATES = {
    "ready": Reason.of("desk.state_ready"),
    "spawning": Reason.of("desk.state_spawning"),
    "running": Reason.of("desk.state_running"),
    "waiting": Reason.of("desk.state_waiting"),
    "joining": Reason.of("desk.state_joining"),
    "paused": Reason.of("desk.state_paused"),
    "stopped": Reason.of("desk.state_stopped"),
    "clearing": Reason.of("desk.state_clearing"),
    "done": Reason.of("desk.state_done"),
    "killing": Reason.of("desk.state_killing"),
    "ended": Reason.of("desk.state_ended"),
}


def lines(positions: Sequence[Position], flow_index: FlowIndex, say: Callable[[Reason], str] = str) -> list[str]:
    """A table: flow, state, action as people count them, and what there is to say besides; `say` makes the words."""
    rows: list[list[Cell]] = [
        [position.subsystem, state(position), _action(position, flow_index), remark(position)] for position in positions
    ]
    head: list[Cell] = [Reason.of("desk.head_flow"), Reason.of("desk.head_state"), Reason.of("desk.head_action"), ""]
    return text_table.lines(head, rows, say)


def state(position: Position) -> Reason:
    """Its state in a word or two."""
    word = state_word(position.state)
    if position.is_pausing and position.state != "paused":
        return Reason.of("desk.state_will_pause", state=word)
    return word


def state_word(flow_state: str) -> Reason:
    """The word for a state of a flow; in English it is the one that a console line takes too."""
    return _STATES.get(flow_state) or Reason.plain(flow_state)


def remark(position: Position) -> Reason:
    """Whom it waits for, which loops it is in, what has failed, where it would pause."""
    parts: list[Reason] = []
    if position.state in ("waiting", "joining"):
        parts.append(waits(position.tag, position.waits_for))
    if position.loops:
        parts.append(Reason.of("desk.in_loops", loops=_nested(position.loops)))
    if position.failed:
        parts.append(Reason.of("desk.failed_tasks", tasks=position.failed))
    if position.breakpoints:
        parts.append(Reason.of("desk.pauses_after", actions=tuple(at + 1 for at in position.breakpoints)))
    return Reason.of("desk.remarks", parts=tuple(parts))


def _nested(loops: Sequence[str]) -> Reason:
    """The innermost loop, and in which ones it is."""
    *outer, innermost = loops
    if not outer:
        return Reason.plain(innermost)
    return Reason.of("desk.loop_in", inner=innermost, outer=_nested(outer))


def waits(tag: str, waits_for: Sequence[str]) -> Reason:
    """What a flow waits for, in words; of a tag the word that stands in the file."""
    word, flows = tag.rpartition(" ")[2], tuple(waits_for)
    if tag and flows:
        return Reason.of("desk.waits_at_for", tag=word, flows=flows)
    if tag:
        return Reason.of("desk.waits_at", tag=word)
    if flows:
        return Reason.of("desk.waits_for", flows=flows)
    return Reason.of("desk.waits")


def _action(position: Position, flow_index: FlowIndex) -> str:
    if position.action < 0:
        return "-"
    count, name = flow_index.count(position.subsystem), flow_index.name(position.subsystem, position.action)
    return f"{position.action + 1}" + (f"/{count}" if count else "") + (f" {name}" if name else "")
