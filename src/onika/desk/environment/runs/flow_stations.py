"""Where the flows of an application are carried out: each at a station, as long as it is open (E12, F02)."""

from dataclasses import replace
from itertools import combinations

from onika.desk.environment.outcome.on_file import on_resting_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.station_names import called
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.wire import act
from onika.wire.plan import Meet, Plan, PlannedFlow
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


def refused(opened: OpenApplication, plan: Plan | None) -> No | None:
    """Why its flows are not carried out at several stations: some would have to meet, which runtimes do not yet do."""
    if plan is None or opened.lone_station is not None:
        return None
    everywhere = tuple(
        Remedy(Reason.of("desk.all_at", station=called(station)), act.PlaceFlow(opened.id, "", station))
        for station in dict.fromkeys(opened.station_of(home) for home in _chiefs(plan))
    )
    tag = _shared_tag(opened, plan)
    return None if tag is None else No(Reason.of("run.meet_at_stations", tag=tag[0], parts=tag[1:]), everywhere)


def apart(opened: OpenApplication, plan: Plan) -> dict[str, str]:
    """Where the flows of a plan are carried out, by subsystem; nothing where all of them are at one station."""
    if opened.lone_station is not None:
        return {}
    return {home: opened.station_of(home) for home in _chiefs(plan)}


def _chiefs(plan: Plan) -> dict[str, list[PlannedFlow]]:
    """The flows that are not nested, by subsystem, each with those that are nested in it."""
    flows: dict[str, list[PlannedFlow]] = {}
    for flow in plan.flows:
        flows.setdefault(flow.subsystem.partition(".")[0], []).append(flow)
    return flows


def _shared_tag(opened: OpenApplication, plan: Plan) -> tuple[str, Reason, Reason] | None:
    """A tag at which flows of two stations would wait for each other, and these; None: there is none."""
    tags = {home: {tag for flow in flows for tag in _tags(flow)} for home, flows in _chiefs(plan).items()}
    for first, second in combinations(tags, 2):
        shared = sorted(tags[first] & tags[second])
        if shared and opened.station_of(first) != opened.station_of(second):
            return shared[0], _placed(opened, first), _placed(opened, second)
    return None


def _tags(flow: PlannedFlow) -> set[str]:
    met = {instruction.tag for instruction in flow.program if isinstance(instruction, Meet)}
    return met | {action.synch_tag for action in flow.actions if action.synch_tag}


def _placed(opened: OpenApplication, home: str) -> Reason:
    return Reason.of("run.flow_at", flow=home, station=called(opened.station_of(home)))
