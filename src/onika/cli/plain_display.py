"""The plain display of a run: one line per event, where there is no terminal."""

from types import TracebackType

from onika.cli.conversation import next_line
from onika.cli.event_text import item_text, lines, summary
from onika.cli.language import say
from onika.cli.lines.hindrance_lines import HindranceLines
from onika.cli.plain_console import PlainConsole
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.plan.preparation import PreparedRun
from onika.desk.run import positions as places
from onika.desk.run.outcome import Outcome
from onika.wire import event
from onika.wire.steer import Position
from onika.words.fault import Fault
from onika.words.reason import Reason


class PlainDisplay:
    """Writes to standard output."""

    def __init__(self) -> None:
        self._total = 0
        self._cast = FlowIndex(())
        self._input = PlainConsole()
        self._hindrance = HindranceLines()

    def __enter__(self) -> "PlainDisplay":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        pass

    def begins(self, prepared: PreparedRun, runtime_pid: int | None) -> None:
        """The name and how much there is to do."""
        del runtime_pid
        if prepared.plan is not None:
            self._cast = FlowIndex.of(prepared.plan)
            self._total = max(len(flow.actions) for flow in prepared.plan.flows)
            count = sum(len(flow.actions) for flow in prepared.plan.flows)
            self._write(say(Reason.of("cli.run_begins", name=prepared.name, count=count)))

    def happens(self, happening: event.Event) -> None:
        """Its lines, if there are any."""
        for line in (*lines(happening, self._total, self._cast.subsystems), self._hindrance.line(happening, say)):
            if line:
                self._write(line)

    @property
    def can_steer(self) -> bool:
        """Nobody is there."""
        return False

    def wishes(self) -> tuple[str, ...]:
        """None."""
        return ()

    def looks(self) -> bool:
        """Nobody does."""
        return False

    def placed(self, positions: tuple[Position, ...]) -> None:
        """Nobody looks."""

    def steered(self, line: str, faults: tuple[Fault, ...], positions: tuple[Position, ...]) -> None:
        """The line of a script, and what came of it."""
        self._write(f"> {line}")
        for fault in faults:
            self._write(say(fault.sentence))
        if positions:
            for row in places.lines(positions, self._cast, say):
                self._write(row)

    def answer(self, question: event.Asked) -> str | None:
        """Ask on the terminal that input comes from; None at the end of the input."""
        wanted = Reason.of("cli.items", items=tuple(map(item_text, question.items)))
        asks = Reason.of("cli.asks_for", task=question.task, wanted=wanted)
        if question.reason:
            asks = Reason.of("cli.asks_because", task=question.task, wanted=wanted, reason=question.reason)
        self._write(f"{say(asks)}:")
        return next_line(self._input, "")

    def ended(self, outcome: Outcome, drawn: Reason) -> None:
        """The summary."""
        for line in summary(outcome, drawn):
            self._write(say(line.reason))

    def _write(self, line: str) -> None:
        print(line, flush=True)
