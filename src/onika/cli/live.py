"""A run on a terminal: what is done above, what goes on below, redrawn as it happens."""

from time import monotonic
from types import TracebackType

from rich.columns import Columns
from rich.console import Console, Group
from rich.live import Live as Screen
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from onika.cli.told import asked_item, sentence, summary
from onika.cli.typed import typed_line
from onika.desk.preparation import PreparedRun
from onika.desk.run import Outcome
from onika.wire import event

_MARKS = {
    "ON": ("▶", "cyan"),
    "OFF": ("○", "bright_black"),
    "WAITING": ("⧗", "bright_black"),
    "ASKING": ("?", "magenta"),
    "ERROR": ("✕", "bold red"),
}
_BAR = 40


class Live:
    """Actions scroll by; the panel at the bottom shows the present one, the time and every task's state."""

    def __init__(self) -> None:
        self._console = Console(highlight=False)
        self._name = ""
        self._totals: list[int] = []
        self._done = 0
        self._now: dict[int, str] = {}
        self._states: dict[tuple[str, str], str] = {}
        self._since = monotonic()
        # last, because it draws at once
        self._screen = Screen(console=self._console, refresh_per_second=12, get_renderable=self._panel, transient=True)

    def __enter__(self) -> "Live":
        self._screen.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._screen.stop()

    def begins(self, prepared: PreparedRun, runtime_pid: int | None) -> None:
        """What there is to do."""
        del runtime_pid
        self._name = prepared.name
        self._since = monotonic()
        if prepared.plan is not None:
            self._totals = [len(flow.actions) for flow in prepared.plan.flows]

    def happens(self, one: event.Event) -> None:
        """Remember it for the panel; say it above where it is worth a line."""
        match one:
            case event.Began():
                self._now[one.flow] = one.action
            case event.Done():
                self._done += 1
            case event.TaskState():
                self._states[one.subsystem, one.task] = one.state
        line = sentence(one, max(self._totals, default=0))
        if line:
            style = "red" if isinstance(one, event.Failed) else "yellow" if isinstance(one, event.Warned) else ""
            self._console.print(Text(line, style=style))

    def answer(self, asked: event.Asked) -> str | None:
        """Ask for it in the terminal, value by value; None at the end of the input."""
        self._screen.stop()
        if asked.reason:
            self._console.print(Text(asked.reason, style="magenta"))
        words: list[str] = []
        for one in asked.items:
            question = f"{asked.task} asks for {asked_item(one)}: "
            self._console.print(Text(question), end="")
            line = typed_line()
            if line is None:
                return None
            words.append(line)
        self._screen.start()
        return " ".join(words)

    def ended(self, outcome: Outcome, drawn: str) -> None:
        """The summary."""
        good = outcome.exit_code == 0
        for line in summary(outcome, drawn):
            is_verdict = line.startswith(f"{outcome.name}: ")
            style = ("bold green" if good else "bold red") if is_verdict else "red" if ": NO" in line else ""
            self._console.print(Text(line, style=style))

    def _panel(self) -> Group | Text:
        if not self._totals:
            return Text("preparing …", style="bright_black")
        total = sum(self._totals)
        head = Table.grid(padding=(0, 2))
        actions = "  |  ".join(self._now[flow] for flow in sorted(self._now))
        head.add_row(
            Text(self._name, style="bold"),
            ProgressBar(total=total, completed=self._done, width=_BAR),
            Text(f"{self._done} of {total} done"),
            Text(f"{monotonic() - self._since:6.1f} s"),
            Text(actions, style="bold cyan"),
        )
        states = Columns(
            [
                Text(f"{_MARKS[state][0]} {task}", style=_MARKS[state][1], no_wrap=True)
                for (_, task), state in sorted(self._states.items())
                if state != "KILLED"
            ],
            padding=(0, 2),
        )
        return Group(Text(), head, states)
