"""A run as plain lines, where there is no terminal."""

from types import TracebackType

from onika.cli.told import asked_item, sentence, summary
from onika.cli.typed import typed_line
from onika.desk.preparation import PreparedRun
from onika.desk.run import Outcome
from onika.wire import event


class Plain:
    """Writes to standard output."""

    def __init__(self) -> None:
        self._total = 0

    def __enter__(self) -> "Plain":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        pass

    def begins(self, prepared: PreparedRun, runtime_pid: int | None) -> None:
        """The name and how much there is to do."""
        del runtime_pid
        if prepared.plan is not None:
            self._total = max(len(flow.actions) for flow in prepared.plan.flows)
            self._write(f"{prepared.name}: {sum(len(flow.actions) for flow in prepared.plan.flows)} actions")

    def happens(self, one: event.Event) -> None:
        """One line, or none."""
        line = sentence(one, self._total)
        if line:
            self._write(line)

    def answer(self, asked: event.Asked) -> str | None:
        """Ask on the terminal that input comes from; None at the end of the input."""
        wanted = "; ".join(asked_item(one) for one in asked.items)
        reason = f" ({asked.reason})" if asked.reason else ""
        self._write(f"{asked.task} asks for {wanted}{reason}:")
        return typed_line()

    def ended(self, outcome: Outcome, drawn: str) -> None:
        """The summary."""
        for line in summary(outcome, drawn):
            self._write(line)

    def _write(self, line: str) -> None:
        print(line, flush=True)
