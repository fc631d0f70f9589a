"""Where the flows of an application are carried out: each at a station, as long as it is open (E12, F02)."""

from dataclasses import replace

from onika.desk.environment.outcome.on_file import on_resting_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.station_names import called
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.wire import act
from onika.wire.plan import Plan
from onika.wire.view import Remedy
from onika.words.reason import Reason


@on_resting_application
def place_flow(model: Model, opened: OpenApplication, command: act.PlaceFlow, _outside: Services) -> Done | No:
    """Have a flow, or all of them, carried out at a station."""
    if not command.flow:
        stations = {"": command.station} if command.station else {}
    elif command.flow not in (f"flow{number}" for number in range(len(opened.application.flows))):
        return No(Reason.of("desk.no_flow_to_place", name=command.flow))
    else:
        stations = {**opened.stations, command.flow: command.station}
    return Done(model.with_application(replace(opened, stations=stations, marks={}, looked=None)))


def together(opened: OpenApplication, plan: Plan) -> tuple[Remedy, ...]:
    """Ways out where flows at several stations cannot meet: all of them at one."""
    stations = dict.fromkeys(opened.station_of(home) for home in _chiefs(plan))
    return tuple(
        Remedy(Reason.of("desk.all_at", station=called(station)), act.PlaceFlow(opened.id, "", station))
        for station in stations
    )


def apart(opened: OpenApplication, plan: Plan) -> dict[str, str]:
    """Where the flows of a plan are carried out, by subsystem; nothing where all of them are at one station."""
    if opened.lone_station is not None:
        return {}
    return {home: opened.station_of(home) for home in _chiefs(plan)}


def _chiefs(plan: Plan) -> tuple[str, ...]:
    """The subsystems of the flows that are not nested."""
    return tuple(flow.subsystem for flow in plan.flows if flow.parent is None)
