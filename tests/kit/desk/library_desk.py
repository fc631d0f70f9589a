"""An environment of a user who has a home and a cache, and may take libraries of others."""

from dataclasses import replace
from datetime import UTC, date, datetime
from pathlib import Path
from typing import Any

from kit.desk.environment_fixture import EnvironmentFixture
from kit.labs.library_site import TODAY, LibrarySite
from onika.desk.environment.initial_model import opened
from onika.desk.environment.outcome.library_services import LibraryServices
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.store.live_path import LivePath
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.lock_file import LockFile
from onika.store.remote.object_cache import ObjectCache
from onika.store.remote.remote_libraries import RemoteLibraries
from onika.store.site import open_site
from onika.wire import act
from onika.wire.view import OfferView


class LibraryDesk(EnvironmentFixture):
    """`folder` holds home, cache and state; it is noon of `today`."""

    def __init__(self, folder: Path, today: date = TODAY) -> None:
        (folder / "home").mkdir(exist_ok=True)
        site = open_site([], {"XDG_CACHE_HOME": str(folder / "cache")}, folder / "home")
        path = LivePath(site.directories)
        site = replace(site, directories=path)
        model, _ = opened(site, None, {})
        super().__init__(folder, (), model, site)
        assert site.own is not None
        access = LibraryAccess(ObjectCache(folder / "cache" / "onika"), folder / "state")
        libraries = RemoteLibraries(LockFile(site.own), access)
        remote = LibraryServices(BackgroundWorker(self.changes.put), libraries, path)
        noon = datetime.combine(today, datetime.min.time(), UTC).timestamp() + 43200
        self.surroundings = replace(self.surroundings, remote=remote, calendar=lambda: noon, state=folder / "state")
        self.begin(model)

    def value(self, command: act.AnyAct) -> Any:
        answer = self.later(command)
        assert answer.no is None, answer.no
        return answer.value

    def browse(self, site: LibrarySite) -> OfferView:
        offer: OfferView = self.value(act.BrowseLibrary(str(site.folder)))
        return offer

    def take(self, site: LibrarySite) -> str:
        return str(self.value(act.TakeLibrary(str(site.folder), self.browse(site).digest)))

    def tasks(self) -> set[str]:
        return set(self.environment.tree.tasks)
