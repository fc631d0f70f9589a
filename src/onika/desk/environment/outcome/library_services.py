"""What acts on libraries of others need of the outside."""

from dataclasses import dataclass

from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.store.live_path import LivePath
from onika.store.remote.remote_libraries import RemoteLibraries


@dataclass(frozen=True, slots=True)
class LibraryServices:
    """Used by acts.

    worker     may wait for servers; all that asks them is done there, one thing after the other
    libraries  those of the user's own base directory
    path       the search path of the session
    """

    worker: BackgroundWorker
    libraries: RemoteLibraries
    path: LivePath

    def close(self) -> None:
        """Nothing more is asked for."""
        self.worker.close()
        self.libraries.access.close()
