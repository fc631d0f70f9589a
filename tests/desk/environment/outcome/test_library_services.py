from onika.desk.environment.outcome.library_services import LibraryServices
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.store.live_path import LivePath
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.lock_file import LockFile
from onika.store.remote.object_cache import ObjectCache
from onika.store.remote.remote_libraries import RemoteLibraries


def test_when_all_is_over_nothing_more_is_asked_for(tmp_path):  # R-F03
    done = []
    libraries = RemoteLibraries(LockFile(tmp_path), LibraryAccess(ObjectCache(tmp_path), None))
    services = LibraryServices(BackgroundWorker(done.append, "fetching"), libraries, LivePath(()))
    services.close()
    services.worker.tell(lambda model: model)
    assert done == []
