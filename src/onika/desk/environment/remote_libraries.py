"""Acts on libraries of others: looked at, taken, renewed and dropped while the environment lives (F03, F06, law 21)."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime
from functools import partial
from pathlib import Path

from onika.desk.environment.canvas import libraries as open_ones
from onika.desk.environment.file import file_index
from onika.desk.environment.icons import dictionaries
from onika.desk.environment.outcome.outcome import Done, No, Procedure, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.refresh import refreshed
from onika.desk.environment.state.model import Model
from onika.files.library_lock import LockedLibrary
from onika.store.base_directory import BaseDirectory
from onika.store.remote.address import WebAddress, library_address
from onika.store.remote.contents import LibraryEntry, contents
from onika.store.remote.credential import Credential
from onika.store.remote.index_check import refusal
from onika.store.remote.library_access import PASSWORD_REASONS
from onika.store.remote.library_changes import changes
from onika.store.remote.own_changes import own_changes
from onika.store.remote.remote_libraries import NewerVersion, Offer, RemoteLibraries
from onika.wire import act, page
from onika.wire.view import OfferEntryView, OfferView, UsedLibraryView
from onika.words.fault import Refusal
from onika.words.reason import Reason

_NOT_HERE = No(Reason.of("desk.no_remote_libraries"))


def list_remote_libraries(model: Model, _asked: act.ListRemoteLibraries, outside: Services) -> Procedure:
    """Those that are used; the value is a tuple of `view.UsedLibraryView`."""
    services = outside.remote
    if services is None:
        return _NOT_HERE
    model, used = yield Work(model, services.worker, partial(_used, services.libraries))
    return Done(model, value=used)


def browse_library(model: Model, command: act.BrowseLibrary, outside: Services) -> Procedure:
    """What a library offers; the value is a `view.OfferView`."""
    services = outside.remote
    if services is None:
        return _NOT_HERE
    today = _today(outside)
    model, offer = yield Work(model, services.worker, partial(_offered, services.libraries, command, today))
    return _refused(offer) if isinstance(offer, Reason) else Done(model, value=offer)


def take_library(model: Model, command: act.TakeLibrary, outside: Services) -> Procedure:
    """Use what was shown; the value is the path of its base directory. Its code is fetched and run by nobody."""
    services = outside.remote
    if services is None:
        return _NOT_HERE
    today = _today(outside)
    model, taken = yield Work(model, services.worker, partial(_taken, services.libraries, command, today))
    if isinstance(taken, Reason):
        return _refused(taken)
    folder = services.libraries.checkout(taken.library).folder
    services.path.add(BaseDirectory(folder))
    if folder not in model.search:
        model = replace(model, search=(*model.search, folder))
    done = refreshed(model, _files(folder), outside.site)
    says = [page.Say("warning", taken.not_fetched)] if taken.not_fetched else []
    return replace(done, value=str(folder), says=(*done.says, *says))


def drop_library(model: Model, command: act.DropLibrary, outside: Services) -> Procedure:
    """Use a library no longer: it is closed, and gone from the search path."""
    services = outside.remote
    if services is None:
        return _NOT_HERE
    library = services.libraries.find(command.library)
    if library is None:
        return No(Reason.of("store.library_unknown", library=command.library))
    base = BaseDirectory(services.libraries.checkout(library).folder)
    model, refused = yield Work(model, services.worker, partial(services.libraries.remove, library.name))
    if isinstance(refused, Refusal):
        return No(refused.reason)
    services.path.remove(base)
    return _closed(model, base)


def give_library_rights(model: Model, command: act.GiveLibraryRights, outside: Services) -> Procedure:
    """What the code of a library may do, from the next time on that it is begun."""
    services = outside.remote
    if services is None:
        return _NOT_HERE
    library = services.libraries.find(command.library)
    if library is None:
        return No(Reason.of("store.library_unknown", library=command.library))
    give = partial(services.libraries.give_rights, library, has_all_rights=command.all_rights)
    model, given = yield Work(model, services.worker, give)
    return No(given.reason) if isinstance(given, Refusal) else Done(model)


@dataclass(frozen=True, slots=True)
class _Taken:
    library: LockedLibrary
    not_fetched: Reason
    """Why its code is not here yet; it can be fetched later."""


def _used(libraries: RemoteLibraries) -> tuple[UsedLibraryView, ...]:
    views = []
    for library in libraries.listed()[0]:
        checkout = libraries.checkout(library)
        views.append(
            UsedLibraryView(
                library.name,
                library.address,
                library.signer,
                library.trusted,
                library.version,
                library.until.isoformat(),
                str(checkout.folder),
                len(checkout.lacking()),
                len(own_changes(checkout)),
                library.has_all_rights,
            )
        )
    return tuple(views)


def _offered(libraries: RemoteLibraries, command: act.BrowseLibrary, today: date) -> OfferView | Reason:
    place = library_address(command.address)
    if isinstance(place, WebAddress) and command.secret:
        libraries.access.let_in(place, Credential(command.secret, command.user))
    offer = libraries.offer(command.address, today)
    libraries.access.hang_up()
    if isinstance(offer, Reason):
        return offer
    library = libraries.find(offer.index.name)
    index, found = offer.index, offer.found
    head = OfferView(
        command.address,
        index.name,
        index.version,
        index.until.isoformat(),
        found.signer,
        found.digest,
        index.description,
        tuple(map(_entry, contents(index))),
    )
    return head if library is None else _beside(head, offer, library, today)


def _beside(head: OfferView, offer: Offer, library: LockedLibrary, today: date) -> OfferView:
    """What is offered beside what is used: what is new in it, and whether it may take its place."""
    new = changes(library, offer.index)
    further = tuple(
        (task, tuple(sorted(more.writes | more.touches))) for task, more in sorted((new.further or {}).items())
    )
    why_not = _not_following(offer, library, today)
    entries = contents(offer.index, frozenset((*new.added, *new.altered)))
    return OfferView(
        head.address,
        head.name,
        head.version,
        head.until,
        head.signer,
        head.digest,
        head.description,
        tuple(map(_entry, entries)),
        library.version,
        further,
        why_not or None,
    )


def _not_following(offer: Offer, library: LockedLibrary, today: date) -> Reason:
    """Why an offer may not take the place of a library that is used; the same name elsewhere is another library."""
    if offer.address != library.address:
        return Reason.of("store.library_known", library=library.name, address=library.address)
    return refusal(offer.found, library, today)


def _taken(libraries: RemoteLibraries, command: act.TakeLibrary, today: date) -> _Taken | Reason:
    offer = libraries.offer(command.address, today)
    if isinstance(offer, Reason):
        return offer
    if offer.found.digest != command.digest:
        return Reason.of("desk.library_changed_meanwhile", library=offer.index.name)
    library = libraries.find(offer.index.name)
    if library is None:
        kept = libraries.add(offer, today.isoformat())
    else:
        why_not = _not_following(offer, library, today)
        if why_not:
            return why_not
        kept = libraries.renew(library, NewerVersion(offer, changes(library, offer.index)))
    if isinstance(kept, Refusal):
        return kept.reason
    not_fetched = libraries.fetch(kept)
    libraries.access.hang_up()
    return _Taken(kept, not_fetched)


def _closed(model: Model, base: BaseDirectory) -> Done:
    files = file_index.of_base(model, str(base.path))
    left = [library.base for library in model.libraries.libraries if library.base != base]
    done = open_ones.rearranged(model, left, frozenset())
    shown = [dictionary.base for dictionary in done.model.dictionaries if dictionary.base != base]
    icons = dictionaries.rearranged(done.model, shown, frozenset())
    now = file_index.without(icons.model, files)
    now = replace(now, search=tuple(path for path in now.search if path != base.path))
    return Done(now, says=(*done.says, *icons.says))


def _entry(entry: LibraryEntry) -> OfferEntryView:
    return OfferEntryView(
        entry.kind, entry.name, entry.description, entry.rows, entry.writes, entry.touches, entry.is_new
    )


def _files(folder: Path) -> frozenset[Path]:
    """Everything in a base directory: it has come just now, or any of it may have changed."""
    paths: Iterable[Path] = folder.rglob("*")
    return frozenset(path for path in paths if path.is_file())


def _today(outside: Services) -> date:
    return datetime.fromtimestamp(outside.calendar(), UTC).date()


def _refused(reason: Reason) -> No:
    """A no; where a password is wanted, beside the place for it."""
    return No(reason, fields={"secret": reason} if reason.key in PASSWORD_REASONS else {})
