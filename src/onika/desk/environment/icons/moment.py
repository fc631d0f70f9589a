"""Tasks that live for a moment: the driver of an arm comes ON alone, is read, and is gone again (D23).

Nothing moves: a driver that nobody commands holds (law 4).
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import count

from onika.desk.environment.icons.program_arms import MeasuringTasks
from onika.desk.environment.outcome.outcome import Ask, AwaitedNews, EditEnd, No, Steps
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.state.measuring import MeasuringSubsystem
from onika.desk.environment.state.model import Model
from onika.wire import act, live
from onika.wire.plan import PlannedTask
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import Reason

_NAME = "measuring"

Outcome = tuple[Model, live.Values | No]


def measured(model: Model, standing: Standing, arm: MeasuringTasks, variables: Sequence[str]) -> Steps[Outcome]:
    """What the tasks of an arm measure, in a subsystem of their own that is gone afterwards, whatever happens."""
    if model.measuring is not None:
        return model, No(Reason.of("desk.measured_already"))
    taken = {subsystem.name for subsystem in standing.subsystems}
    name = next(each for number in count(1) if (each := f"{_NAME}-{number}" if number > 1 else _NAME) not in taken)
    model = replace(model, measuring=MeasuringSubsystem(name, station=model.station))
    born = live.Change(name, spawn=arm.tasks, code=arm.code, on=_turns((arm.driver,)))
    model, wrong = yield from _changed(model, born)
    if wrong is None and arm.others:  # what reads the driver comes on when there is something to read
        model, wrong = yield from _changed(model, live.Change(name, on=_turns(arm.others)))
    if wrong is None:
        model, response = yield Ask(model, live.Read(name, tuple(variables)))
        values = response if isinstance(response, live.Values) else No(refusal(response))
    else:
        values = _hindered(model, wrong)
    model, _ = yield from _changed(model, live.Close(name))
    model, standing_after = yield Ask(replace(model, measuring=None), live.Survey())
    if isinstance(standing_after, Standing):  # a world is open now, and the subsystem is no more
        model = replace(model, runtime=runtime_view(model.runtime, standing_after))
    return model, values


def _turns(tasks: Sequence[PlannedTask]) -> tuple[live.Turn, ...]:
    return tuple(live.Turn(task.name) for task in tasks)


def _changed(model: Model, change: live.Change | live.Close) -> Steps[tuple[Model, No | None]]:
    """Carry out a change, and wait for its end."""
    model, response = yield Ask(model, change)
    if not isinstance(response, live.Accepted):
        return model, No(refusal(response))
    measuring = model.measuring
    if measuring is None:
        return model, No(Reason.of("run.not_linked"))
    if response.number in measuring.ends:  # told before the answer came
        cause = measuring.ends[response.number]
        return model, No(cause) if cause else None
    awaiting = replace(model, measuring=replace(measuring, awaits=response.number))
    model, wrong = yield AwaitedNews(awaiting, EditEnd(response.number, model.station))
    if model.measuring is not None:
        model = replace(model, measuring=replace(model.measuring, awaits=None))
    return model, wrong


def _hindered(model: Model, wrong: No) -> No:
    """Why nothing comes to life; while all is stopped it is what would have to be left first."""
    if model.runtime.is_stopped:
        return No(wrong.reason, (Remedy(Reason.of("run.reset"), act.Reset()),))
    return wrong
