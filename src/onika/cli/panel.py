"""The panel at the bottom of a terminal during a run: flows, tasks, keys (requirements E07, E11, X03)."""

from dataclasses import dataclass, field
from time import monotonic

from rich.columns import Columns
from rich.console import Group, RenderableType
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from onika.cli.language import say
from onika.cli.typed_input.key_bindings import KEYS, SHORT, KeyBindings
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run.flow_status import FlowStatus
from onika.desk.run.flow_tracker import FlowTracker
from onika.desk.run.positions import state_word, waits
from onika.wire import event
from onika.wire.steer import Position
from onika.words.reason import Reason

MARKS = {
    "ON": ("▶", "cyan"),
    "OFF": ("○", "bright_black"),
    "WAITING": ("⧗", "bright_black"),
    "ASKING": ("?", "magenta"),
    "ERROR": ("✕", "bold red"),
}
"""How a task's state is shown."""

FLOWS = {
    "ready": ("○", "bright_black"),
    "spawning": ("○", "bright_black"),
    "running": ("▶", "cyan"),
    "waiting": ("⧗", "yellow"),
    "joining": ("⧗", "yellow"),
    "paused": ("‖", "bold yellow"),
    "stopped": ("✕", "bold red"),
    "clearing": ("↻", "magenta"),
    "done": ("✓", "green"),
    "killing": ("○", "bright_black"),
    "ended": ("✓", "bright_black"),
}
"""How a flow's state is shown: its mark and its style."""

_BAR = 16


@dataclass(slots=True)
class Panel:
    """What is shown; it is told what happens and drawn whenever somebody looks."""

    name: str = ""
    flow_index: FlowIndex = field(default_factory=lambda: FlowIndex(()))
    where: FlowTracker = field(default_factory=lambda: FlowTracker(FlowIndex(())))
    bindings: KeyBindings = field(default_factory=KeyBindings)
    has_keys: bool = False
    since: float = field(default_factory=monotonic)
    _positions: dict[str, Position] = field(default_factory=dict)
    _states: dict[tuple[str, str], str] = field(default_factory=dict)

    def begins(self, name: str, flow_index: FlowIndex) -> None:
        """A run of these flows begins."""
        self.name, self.flow_index, self.where = name, flow_index, FlowTracker(flow_index)
        self.bindings = KeyBindings(flow_index.subsystems)
        self.since = monotonic()

    def happens(self, happening: event.Event) -> None:
        """Remember what is shown."""
        self.where.hear(happening)
        if isinstance(happening, event.TaskState):
            self._states[happening.subsystem, happening.task] = happening.state

    def place(self, positions: tuple[Position, ...]) -> None:
        """What the runtime says of its flows."""
        self.where.place(positions)
        self._positions = {position.subsystem: position for position in positions}

    def draw(self) -> RenderableType:
        """As it is now."""
        if not self.flow_index.parts:
            return Text(say(Reason.of("cli.preparing")), style="bright_black")
        rows: list[RenderableType] = [Text(), self._head(), self._flows(), self._tasks()]
        if self.bindings.typed is not None:
            rows.append(Text(f": {self.bindings.typed}▏", style="bold"))
        elif self.has_keys:
            rows.append(self._keys())
        return Group(*rows)

    def _head(self) -> Text:
        return Text.assemble((self.name, "bold"), f"  {monotonic() - self.since:.1f} s")

    def _flows(self) -> Table:
        grid = Table.grid(padding=(0, 2))
        several = len(self.flow_index.parts) > 1
        for number, subsystem in enumerate(self.flow_index.subsystems):
            grid.add_row(*self._flow(number, subsystem, several))
        return grid

    def _flow(self, number: int, subsystem: str, several: bool) -> tuple[RenderableType, ...]:
        spot, count = self.where.statuses[subsystem], max(self.flow_index.count(subsystem), 1)
        mark, style = FLOWS.get(spot.state, ("·", ""))
        word = state_word(spot.state)
        is_chosen = self.bindings.chosen == number
        label = f"{'›' if is_chosen else ' '}{number} {subsystem}" if several else " "
        position = self._positions.get(subsystem)
        return (
            Text(label, style="bold" if is_chosen else "", no_wrap=True),
            ProgressBar(total=count, completed=max(spot.action, 0) + (spot.state in ("done", "ended")), width=_BAR),
            Text(f"{max(spot.action + 1, 0):>3}/{count}", no_wrap=True),
            Text(f"{mark} {say(_state(spot, position, word))}", style=style, no_wrap=True),
            Text(
                _doing(self.flow_index, subsystem, spot, position),
                style="bold cyan" if spot.state == "running" else "",
                no_wrap=True,
                overflow="ellipsis",
            ),
        )

    def _tasks(self) -> Columns:
        several = len({subsystem for subsystem, _ in self._states}) > 1
        return Columns(
            [
                Text(
                    f"{MARKS[state][0]} {subsystem + '/' if several else ''}{task}", style=MARKS[state][1], no_wrap=True
                )
                for (subsystem, task), state in sorted(self._states.items())
                if state != "KILLED"
            ],
            padding=(0, 2),
        )

    def _keys(self) -> Text:
        if not self.bindings.has_help:
            short = (f"{key} {say(meaning)}" for key, meaning in SHORT.items())
            return Text("  ".join(short), style="bright_black")
        words = [f"{key} {say(meaning)}" for key, (_, meaning) in KEYS.items()]
        words += [say(Reason.of("cli.key_break")), say(Reason.of("cli.key_line"))]
        if len(self.flow_index.parts) > 1:
            words.append(say(Reason.of("cli.key_flow")))
        words.append(f"? {say(Reason.of('cli.key_less'))}")
        return Text("   ".join(words), style="bright_black")


def _state(spot: FlowStatus, position: Position | None, word: Reason) -> Reason:
    is_pausing = position is not None and position.is_pausing and spot.state == "running"
    if is_pausing:
        return Reason.of("cli.will_pause")
    return word


def _doing(flow_index: FlowIndex, subsystem: str, spot: FlowStatus, position: Position | None) -> str:
    """What it does, or whom it waits for, and the loops it is in."""
    loops = "" if position is None or not position.loops else f"  ↺ {' ↺ '.join(position.loops)}"
    if spot.state in ("waiting", "joining"):
        return say(waits(spot.tag, spot.waits_for)) + loops
    return (flow_index.name(subsystem, spot.action) if spot.state not in ("killing", "ended") else "") + loops
