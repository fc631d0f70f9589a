"""Which applications run side by side: those whose tasks claim different devices, such as two arms (C18, E12).

Each flow has a subsystem of its own, so that names and modules may occur in several of them; a device that takes
commands has one user.
"""

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.model import Model
from onika.model.planned import task_of
from onika.model.rules.union import devices
from onika.wire import act
from onika.wire.plan import Plan
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import Reason


def refused(model: Model, standing: Standing, plan: Plan, name: str) -> No | None:
    """Why an application cannot run beside what runs: every device that it needs and another has for itself alone."""
    wanted = {device for flow in plan.flows for task in flow.tasks for device in devices(task_of(task))}
    taken = [(home.application, task.claims) for home in standing.subsystems if home.application for task in home.tasks]
    shared: dict[str, list[str]] = {}
    for application, device in taken:
        if device in wanted:
            shared.setdefault(application, []).append(device)
    if not shared:
        return None
    parts = tuple(
        Reason.of("run.device_of_run", application=other, devices=tuple(names)) for other, names in shared.items()
    )
    aborts = [run for run in model.going if run.view.name in shared]
    remedies = (Remedy(Reason.of("run.abort_named", name=run.view.name), act.Steer("abort", run.doc)) for run in aborts)
    return No(Reason.of("run.not_beside", name=name, parts=parts), tuple(remedies))
