"""Acts on other sites: what the network offers, where that is looked for, whose keys are trusted (requirement F06)."""

from collections.abc import Callable
from datetime import UTC, datetime
from functools import partial

from onika.desk.environment.outcome.outcome import Done, No, Procedure, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.fabric.listing import SiteEntry
from onika.fabric.phone_book import Look, PhoneBook
from onika.wire import act
from onika.wire.view import NetworkPlaceView, NetworkRuntimeView, NetworkSiteView, NetworkView
from onika.words.reason import Reason

_NOT_HERE = No(Reason.of("desk.no_network"))


def look(model: Model, _asked: act.LookAtNetwork, outside: Services) -> Procedure:
    """What all places have; the value is a `view.NetworkView`."""
    services = outside.network
    if services is None:
        return _NOT_HERE
    today = datetime.fromtimestamp(outside.calendar(), UTC).date()
    model, found = yield Work(model, services.worker, partial(services.book.look, today))
    return No(found) if isinstance(found, Reason) else Done(model, value=_view(found))


def add_place(model: Model, command: act.AddPlace, outside: Services) -> Procedure:
    """Look there too."""
    return _changed(model, outside, lambda book: book.add_place(command.place), "place")


def drop_place(model: Model, command: act.DropPlace, outside: Services) -> Procedure:
    """Look there no more."""
    return _changed(model, outside, lambda book: book.drop_place(command.place), "place")


def trust_site(model: Model, command: act.TrustSite, outside: Services) -> Procedure:
    """Trust a key."""
    return _changed(model, outside, lambda book: book.trust(command.name, command.signer), "signer")


def _changed(model: Model, outside: Services, change: Callable[[PhoneBook], Reason | None], field: str) -> Procedure:
    services = outside.network
    if services is None:
        return _NOT_HERE
    model, why = yield Work(model, services.worker, partial(change, services.book))
    return Done(model) if why is None else No(why, fields={field: why})


def _view(found: Look) -> NetworkView:
    faults = dict(found.faults)
    places = tuple(NetworkPlaceView(place, faults.get(place)) for place in found.book.places)
    listing = found.listing
    return NetworkView(places, tuple(map(_site, listing.entries)), listing.left_out, listing.bad, listing.unjudged)


def _site(entry: SiteEntry) -> NetworkSiteView:
    card = entry.card
    return NetworkSiteView(
        card.name,
        entry.signer,
        entry.standing,
        card.until.isoformat(),
        card.description,
        tuple(NetworkRuntimeView(runtime.address, runtime.robots) for runtime in card.runtimes),
        card.libraries,
    )
