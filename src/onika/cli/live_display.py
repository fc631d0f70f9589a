"""The live display of a run on a terminal: finished actions above, the present state below, keys to steer (E07)."""

from time import monotonic, sleep
from types import TracebackType

from rich.console import Console
from rich.live import Live as Screen
from rich.text import Text

from onika.cli.conversation import next_line
from onika.cli.event_text import SummaryTone, item_text, lines, summary
from onika.cli.language import say
from onika.cli.lines.hindrance_lines import HindranceLines
from onika.cli.panel import Panel
from onika.cli.terminal import Terminal
from onika.cli.typed_input.keyboard import Keyboard
from onika.desk.console.session import typed_fault
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.plan.preparation import PreparedRun
from onika.desk.run import positions as places
from onika.desk.run.outcome import Outcome
from onika.desk.run.running_application import LINE
from onika.wire import event
from onika.wire.steer import Position
from onika.words.fault import Fault
from onika.words.reason import Reason

_LOOK_S = 0.2
"""How often the runtime is asked at most where its flows are."""
_ABSENT_S = 0.1
"""How long it takes at most until a question notices that the program is back in the foreground."""
_STYLES = {event.Failed: "red", event.Explained: "red", event.Warned: "yellow", event.Moved: "bright_black"}
_TONES = {
    SummaryTone.PLAIN: "",
    SummaryTone.WELL: "bold green",
    SummaryTone.FAILED: "bold red",
    SummaryTone.WRONG: "red",
}


class LiveDisplay:
    """Actions scroll by; the panel at the bottom shows every flow, the time, every task's state and the keys.

    can_steer   whether somebody is at the keyboard
    """

    def __init__(self) -> None:
        self._console = Console(highlight=False)
        self._panel = Panel()
        self._keyboard = Keyboard()
        self._hindrance = HindranceLines()
        self._total = 0
        self._has_moved = False
        self._looked = 0.0
        self._screen = self._new_screen()  # last, because it draws at once

    def __enter__(self) -> "LiveDisplay":
        self._keyboard.__enter__()
        self._screen.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            self._screen.stop()
        finally:
            self._keyboard.__exit__(kind, fault, trace)

    @property
    def can_steer(self) -> bool:
        """Whether somebody is at the keyboard."""
        return self._keyboard.is_there

    def begins(self, prepared: PreparedRun, runtime_pid: int | None) -> None:
        """What there is to do."""
        del runtime_pid
        if prepared.plan is not None:
            self._total = max((len(flow.actions) for flow in prepared.plan.flows), default=0)
            self._panel.begins(prepared.name, FlowIndex.of(prepared.plan))
            self._panel.has_keys = self.can_steer

    def happens(self, happening: event.Event) -> None:
        """Remember it for the panel; say it above where it is worth a line."""
        self._panel.happens(happening)
        self._has_moved = self._has_moved or isinstance(happening, event.Began | event.Moved)
        for line in lines(happening, self._total, self._panel.flow_index.subsystems, self._console.width):
            self._console.print(Text(line, style=_STYLES.get(type(happening), "")))
        if hindrance := self._hindrance.line(happening, say):
            self._console.print(Text(hindrance, style=_STYLES[event.Failed]))

    def answer(self, question: event.Asked) -> str | None:
        """Ask for it in the terminal, value by value; None at the end of the input."""
        self._screen.stop()
        line = self._answers(question)
        if line is not None:
            self._screen = self._new_screen()  # the former would wipe out as many rows as it had before the question
            self._screen.start()
        return line

    def wishes(self) -> list[str]:
        """What the keys want."""
        for key in self._keyboard.pressed():
            self._panel.bindings.press(key)
        return self._panel.bindings.take()

    def looks(self) -> bool:
        """Now and then, where flows have moved or were steered."""
        if not self._has_moved or monotonic() - self._looked < _LOOK_S:
            return False
        self._has_moved, self._looked = False, monotonic()
        return True

    def placed(self, positions: tuple[Position, ...]) -> None:
        """For the panel."""
        self._panel.place(positions)

    def steered(self, line: str, faults: tuple[Fault, ...], positions: tuple[Position, ...]) -> None:
        """What came of a line: where the flows are, or why it was not carried out."""
        self._has_moved = True
        self._console.print(Text(f"> {line}", style="bright_black"))
        for text in places.lines(positions, self._panel.flow_index, say) if positions else ():
            self._console.print(Text(text))
        for fault in faults:
            sentence = typed_fault(fault) if fault.place == LINE else fault.sentence
            self._console.print(Text(say(sentence), style="red"))

    def ended(self, outcome: Outcome, drawn: Reason) -> None:
        """The summary."""
        for line in summary(outcome, drawn):
            self._console.print(Text(say(line.reason), style=_TONES[line.tone]))

    def _new_screen(self) -> Screen:
        return Screen(console=self._console, refresh_per_second=12, get_renderable=self._panel.draw, transient=True)

    def _answers(self, question: event.Asked) -> str | None:
        if question.reason:
            self._console.print(Text(say(question.reason), style="magenta"))
        while self._keyboard.is_in_background:
            sleep(_ABSENT_S)
        words: list[str] = []
        with Terminal(lambda before: []) as terminal:
            for item in question.items:
                asks = Reason.of("cli.asks_for", task=question.task, wanted=item_text(item))
                line = next_line(terminal, f"{say(asks)}: ")
                if line is None:
                    return None
                words.append(line)
        return " ".join(words)
