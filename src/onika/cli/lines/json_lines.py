"""The display of a run as lines of JSON: one object per event, the result last."""

import sys
from collections.abc import Sequence
from types import TracebackType
from typing import Any

import msgspec

from onika.desk.plan.preparation import PreparedRun
from onika.desk.run.outcome import Outcome
from onika.wire import event
from onika.wire.steer import Position
from onika.words.fault import Fault
from onika.words.reason import Reason


class JsonLines:
    """Writes to standard output."""

    def __enter__(self) -> "JsonLines":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        pass

    def begins(self, prepared: PreparedRun, runtime_pid: int | None) -> None:
        """The application and the runtime's process."""
        self._write({"event": "begins", "application": prepared.name, "runtime_pid": runtime_pid})

    def happens(self, happening: event.Event) -> None:
        """Every event but the result, which comes last with more."""
        if not isinstance(happening, event.Result):
            fields = msgspec.to_builtins(happening)
            fields["event"] = fields.pop("type").lower()
            self._write(fields)

    def answer(self, question: event.Asked) -> None:
        """Nobody is there to answer."""

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
        """A line that was carried out, what is wrong with it, where every flow is if it asked for that."""
        fields: dict[str, Any] = {"event": "steered", "line": line, "faults": _plain(faults)}
        if positions:
            fields["flows"] = msgspec.to_builtins(positions)
        self._write(fields)

    def ended(self, outcome: Outcome, drawn: Reason) -> None:
        """The result."""
        fields: dict[str, Any] = {"event": "result", "application": outcome.name, "state": outcome.state}
        fields["faults"] = _plain(outcome.faults)
        fields["notes"] = list(map(str, outcome.notes))
        if outcome.result is not None:
            result = outcome.result
            fields |= {
                "cause": result.cause,
                "actions_done": result.done,
                "actions": result.of,
                "runtime_s": result.runtime_s,
                "wall_s": round(result.wall_s, 3),
                "values": result.values,
                "expectations": [
                    {"expect": condition.text, "found": value, "holds": holds}
                    for condition, value, holds in outcome.expectations
                ],
                "missed": {f"{task.subsystem}/{task.task}": task.missed for task in result.tasks},
                "tasks": msgspec.to_builtins(result.tasks),
                "switches_us": result.switches_us,
                "skews_us": result.skews_us,
                "steps": msgspec.to_builtins(result.steps),
                "failed": _plain(outcome.failed),
                "hash": result.hash,
                "outside": list(result.outside),
                "black_box": result.black_box,
                "remarks": result.remarks,
                "printed": outcome.printed,
            }
        if drawn:
            fields["picture"] = str(drawn)
        fields["exit"] = outcome.exit_code
        self._write(fields)

    def _write(self, fields: dict[str, Any]) -> None:
        sys.stdout.write(msgspec.json.encode(fields).decode() + "\n")
        sys.stdout.flush()


def _plain(faults: Sequence[Fault]) -> list[dict[str, Any]]:
    return [
        {"file": fault.place.file, "line": fault.place.line, "reason": fault.reason, "instead": fault.instead}
        for fault in faults
    ]
