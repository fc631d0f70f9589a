"""The arms of the open application, as acts about a place mean them: the nearest to a place of it first."""

from collections.abc import Sequence

from onika.desk.environment.icons.measured_variables import MeasuredVariable
from onika.desk.environment.icons.program_arms import MeasuringTasks, arms_of, jobs_near
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.state.model import Model
from onika.wire import act


def arms_meant(
    model: Model, command: act.Teach | act.PointAt, measures: Sequence[MeasuredVariable], outside: Services
) -> tuple[MeasuringTasks, ...]:
    """Those that measure these variables, the one that is meant first; none where no application is open."""
    opened = model.applications.get(command.doc)
    if opened is None or model.syntax is None:
        return ()
    plan = ready(opened, outside.site, model.syntax).plan
    if plan is None:
        return ()
    jobs = jobs_near(opened.application, command.flow, command.after)
    arms = arms_of(plan, jobs, frozenset(measure.variable for measure in measures), model.libraries)
    return tuple(sorted(arms, key=lambda arm: arm.arm != command.arm))
