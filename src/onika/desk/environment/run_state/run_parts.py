"""A run whose flows are carried out by several runtimes, in one account (requirements E12, F02)."""

from dataclasses import replace
from itertools import chain

from msgspec import structs

from onika.desk.environment.run_state.run import Run, RunPart
from onika.wire import event
from onika.words.reason import NOTHING, Reason


def of_whole(run: Run, message: event.Event, station: str) -> tuple[Run, event.Event | None]:
    """What one of the runtimes tells, as of the whole run; None: it is the end of one part, and others go on."""
    part = next((part for part in run.parts if part.station == station), None)
    if part is None:
        return run, message
    match message:
        case event.Began() | event.Done() if message.flow < len(part.flows):
            return run, structs.replace(message, flow=part.flows[message.flow])
        case event.Result():
            return ended(run, station, message)
    return run, message


def ended(run: Run, station: str, result: event.Result) -> tuple[Run, event.Result | None]:
    """A part has come to its end; with the last one the run has, and how is said of all of them together."""
    parts = tuple(replace(part, result=result) if part.station == station else part for part in run.parts)
    run = replace(run, parts=parts)
    results = [part.result for part in parts if part.result is not None]
    return run, _together(parts, results) if len(results) == len(parts) else None


def is_ended_at(run: Run, station: str) -> bool:
    """Whether nothing of it goes on there any more."""
    return any(part.station == station and part.result is not None for part in run.parts)


def _together(parts: tuple[RunPart, ...], results: list[event.Result]) -> event.Result:
    failed = [part for part in parts if part.result is not None and not part.result.completed]
    causes = tuple(_cause(part) for part in failed)
    last = max(results, key=lambda result: result.runtime_s)
    return event.Result(
        completed=not failed,
        cause=Reason.of("run.together", parts=causes) if causes else NOTHING,
        done=sum(result.done for result in results),
        of=sum(result.of for result in results),
        runtime_s=last.runtime_s,
        wall_s=last.wall_s,
        values=dict(chain.from_iterable(result.values.items() for result in results)),
        tasks=tuple(chain.from_iterable(result.tasks for result in results)),
        hash="",
        skews_us=tuple(chain.from_iterable(result.skews_us for result in results)),
        steps=tuple(chain.from_iterable(result.steps for result in results)),
        black_box="".join([result.black_box for result in results if result.black_box][:1]),
        remarks=tuple(chain.from_iterable(result.remarks for result in results)),
    )


def _cause(part: RunPart) -> Reason:
    why = NOTHING if part.result is None else part.result.cause
    what = part.station or Reason.of("desk.station_here")
    return Reason.of("run.what_why", what=what, why=why)
