"""Acts on the stations of an environment: one more runtime is connected, another is left (requirements F02, C18)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile import run_reducer
from onika.desk.environment.reconcile.following import given_up
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.presence import ask_company, ask_flows
from onika.desk.environment.reconcile.station_names import HERE, station_at, station_name
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.run.runtime_conversation import in_short
from onika.link.starting.runtime_address import address_of
from onika.wire import act, live, view
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.name import TASK_NAME
from onika.words.reason import Reason, reason_of


def add_station(model: Model, command: act.AddStation, _outside: Services) -> No | Procedure:
    """Connect with one more runtime; where that fails all else stays as it was. The value is the station's name."""
    named = _named(model, command)
    if isinstance(named, No):
        return named
    return _connected(model, command, *named)


def remove_station(model: Model, command: act.RemoveStation, _outside: Services) -> Done | No:
    """Leave the runtime of a station, with the configurations that are turned on there."""
    name = command.name
    if name not in model.stations or not name:
        return No(Reason.of("desk.no_station", name=name))
    there = model.at(name)
    living = [document for document in there.documents_here.values() if document.live and document.live.tasks]
    names = (*(run.view.name for run in there.going_here), *(document.name for document in living))
    if names and not command.confirmed:
        leave = Remedy(Reason.of("desk.leave_station"), structs.replace(command, confirmed=True))
        return No(Reason.of("desk.station_has", name=name, names=names), (leave,))
    ended = run_reducer.lost(there, Reason.of("desk.station_left", name=name))
    after = ended.model
    for document in there.documents_here.values():
        after = after.with_document(_without_station(document))
    for opened in after.applications.values():
        if name in opened.stations.values():
            stations = {flow: station for flow, station in opened.stations.items() if station != name}
            after = after.with_application(replace(opened, stations=stations))
    after = after.at("").without_station(name)
    return Done(after, says=ended.says, news=(*ended.news, *given_up(model, after)))


def _named(model: Model, command: act.AddStation) -> tuple[str, str] | No:
    """The name and the address of the station that is meant."""
    url = command.url.strip()
    if not url:
        known = model.stations.get(command.name)
        if known is None or not known.address:
            return No(Reason.of("desk.no_station", name=command.name))
        return command.name, known.address
    try:
        url = str(address_of(url))
    except ValueError as wrong:
        return No(reason_of(wrong), fields={"url": reason_of(wrong)})
    name = command.name or station_name(model, url)
    if not TASK_NAME.match(name) or name == HERE:
        return No(Reason.of("desk.no_station_name", name=name), fields={"name": Reason.of("desk.name_of_letters")})
    at_address = station_at(model, url)
    if at_address is not None and at_address != name:
        return No(Reason.of("desk.station_there", name=at_address or HERE, url=url))
    if name in model.stations and at_address is None:
        taken = Reason.of("desk.station_taken", name=name, url=model.stations[name].address)
        return No(taken, fields={"name": taken})
    return name, url


def _connected(model: Model, command: act.AddStation, name: str, url: str) -> Procedure:
    is_new = name not in model.stations
    there = model.at("").with_station(name, model.stations.get(name, view.RuntimeView())).at(name)
    if there.runtime.state != "linked":
        there = replace(there, runtime=view.RuntimeView("starting", url))
    there, standing = yield Ask(there, live.Survey(), RequiredRuntime(url, command.token))
    if isinstance(standing, Standing):
        there = replace(there, runtime=runtime_view(there.runtime, standing))
        return Done(there, value=name, orders=(ask_company(), ask_flows()))
    why = in_short(refusal(standing))
    if is_new and not command.keeps:
        yield InterimModel(there.at("").without_station(name))
    else:
        yield InterimModel(replace(there, runtime=structs.replace(there.runtime, state="lost", text=why)))
    return No(Reason.of("desk.station_not_reached", name=name, url=url, why=why))


def _without_station(document: Document) -> Document:
    """A configuration whose station is left: its layout stays."""
    content = replace(document.content, wanted={}, kept=())
    return replace(document, content=content, live=None, watched=None, taken=None, station="")
