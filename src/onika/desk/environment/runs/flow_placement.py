"""Where the flows of a run live: the runtime, its units, and names of subsystems that nobody else has."""

from collections.abc import Collection, Mapping
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.model import Model
from onika.desk.plan.compile import UNKNOWN
from onika.desk.plan.subsystem_renaming import chiefs
from onika.wire import act, view
from onika.wire.plan import Plan
from onika.wire.view import Remedy
from onika.words.reason import Reason

_ANEW = Remedy(Reason.of("run.start_runtime_anew"), act.StartAnew())


def starting(runtime: view.RuntimeView) -> view.RuntimeView:
    """The runtime while it is got hold of."""
    return view.RuntimeView("starting", runtime.address)


def lost(model: Model, reason: Reason) -> Model:
    """The model where it could not be got hold of."""
    return replace(model, runtime=structs.replace(model.runtime, state="lost", text=reason))


def refused(model: Model, plan: Plan) -> No | None:
    """Why nothing can run there now."""
    runtime = model.runtime
    if runtime.is_stopped:
        allow = Remedy(Reason.of("run.allow_motion"), act.Reset())
        if runtime.stop_text:
            return No(Reason.of("run.everything_stopped_why", why=runtime.stop_text), (allow,))
        return No(Reason.of("run.everything_stopped_first"), (allow,))
    units = runtime.units
    wanted = {_unit(task.rtpu, units) for flow in plan.flows for task in flow.tasks}
    gone = sorted(name for name in wanted if name not in units or units[name].is_lost)
    if gone:
        lost_unit = (_unit_anew(gone[0]),) if gone[0] in units else ()
        return No(Reason.of("run.unit_lost", name=gone[0]), (*lost_unit, _ANEW))
    return None


def _unit_anew(name: str) -> Remedy:
    return Remedy(Reason.of("run.start_unit_anew", name=name), act.AddUnit(name))


def notes(model: Model, plan: Plan) -> tuple[Reason, ...]:
    """Units that tasks name and that are not there."""
    units = model.runtime.units
    named = {task.rtpu for flow in plan.flows for task in flow.tasks} - {UNKNOWN, *units}
    instead = _unit(UNKNOWN, units)
    return tuple(Reason.of("run.no_unit", name=name, instead=instead) for name in sorted(named))


def free(model: Model, plan: Plan, taken: Collection[str]) -> dict[str, str]:
    """A subsystem for each flow that is not nested: of its own name, else of one that nobody has."""
    documents = model.documents_here.values()
    connected = {document.live.subsystem for document in documents if document.live is not None}
    put_back = {document.taken.subsystem for document in documents if document.taken is not None}
    used = {name.partition(".")[0] for name in (*taken, *connected, *put_back)}
    homes: dict[str, str] = {}
    number = 0
    for home in chiefs(plan):
        name = home
        while name in used:
            number += 1
            name = f"{home}-{number}"
        used.add(name)
        homes[home] = name
    return homes


def _unit(wanted: str, units: Mapping[str, view.UnitView]) -> str:
    """The unit of a task: the one it names, else the first that lives (reading 12)."""
    if wanted in units:
        return wanted
    living = [name for name, unit in units.items() if not unit.is_lost]
    return next(iter(living or units), UNKNOWN)
