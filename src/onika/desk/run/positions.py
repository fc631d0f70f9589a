"""Where every flow is, as lines for people (requirements E11, X03)."""

from collections.abc import Sequence

from onika.desk.plan.flow_index import Cast
from onika.desk.run import text_table
from onika.wire.steer import Position


def lines(positions: Sequence[Position], cast: Cast) -> list[str]:
    """A table: flow, state, action as people count them, and what there is to say besides."""
    rows = [[one.subsystem, state(one), _action(one, cast), remark(one)] for one in positions]
    return text_table.lines(["flow", "state", "action", ""], rows)


def state(one: Position) -> str:
    """Its state in a word or two."""
    return f"{one.state}, will pause" if one.is_pausing and one.state != "paused" else one.state


def remark(one: Position) -> str:
    """Whom it waits for, which loops it is in, what has failed, where it would pause."""
    parts = [waits(one.tag, one.waits_for)] if one.state in ("waiting", "joining") else []
    parts += [f"in loop {' in '.join(reversed(one.loops))}"] if one.loops else []
    parts += [f"failed: {', '.join(one.failed)}"] if one.failed else []
    parts += [f"pauses after {', '.join(str(at + 1) for at in one.breakpoints)}"] if one.breakpoints else []
    return "; ".join(parts)


def waits(tag: str, waits_for: Sequence[str]) -> str:
    """What a flow waits for, in words; of a tag the word that stands in the file."""
    at = f" at {tag.rpartition(' ')[2]}" if tag else ""
    return f"waits{at}" + (f" for {' and '.join(waits_for)}" if waits_for else "")


def _action(one: Position, cast: Cast) -> str:
    if one.action < 0:
        return "-"
    count, name = cast.count(one.subsystem), cast.name(one.subsystem, one.action)
    return f"{one.action + 1}" + (f"/{count}" if count else "") + (f" {name}" if name else "")
