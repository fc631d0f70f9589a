"""What a scope of the page shows: values of variables at every cycle, asked for again and again (C14, C27)."""

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.watches import homes_of, homes_within
from onika.desk.environment.state.model import Model
from onika.desk.run.sample_series import SampleSeries, columns
from onika.wire import act
from onika.wire.samples import Sample, Sampled, SampleTrace
from onika.wire.view import SampledView
from onika.words.reason import Reason


def sample(model: Model, command: act.SampleVariables, _outside: Services) -> No | Procedure:
    """What came of each variable after the numbers given; the value is a tuple of `view.SampledView`."""
    homes = {**homes_of(model), **homes_within(model)}
    keys = [key.partition("/") for key in command.variables]
    away = next((doc for doc, _, _ in keys if doc not in homes), None)
    if away is not None or not keys:
        return No(Reason.of("desk.not_sampled"))
    names = tuple(f"{homes[doc]}/{name}" for doc, _, name in keys)
    return _sampled(model, command, Sample(names, command.after))


def _sampled(model: Model, command: act.SampleVariables, asked: Sample) -> Procedure:
    model, response = yield Ask(model, asked)
    if not isinstance(response, Sampled):
        return No(refusal(response))
    after = command.after or (0,) * len(command.variables)
    views = zip(command.variables, response.traces, after, strict=True)
    return Done(model, value=tuple(_view(variable, trace, last) for variable, trace, last in views))


def _view(variable: str, trace: SampleTrace, after: int) -> SampledView:
    series = SampleSeries(trace.variable, last=after)
    series.take(trace)
    return SampledView(
        variable,
        series.last,
        series.missed,
        tuple(columns(variable.partition("/")[2], series.shape)),
        tuple(at * 1e-9 for at in series.times),
        tuple(map(tuple, series.rows)),
        trace.reason or None,
    )
