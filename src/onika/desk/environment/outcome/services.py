"""What an act may look at outside the model: files, time, and whatever else is not a value."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from onika.desk.environment.outcome.button_commands import Commands
from onika.desk.environment.outcome.library_services import LibraryServices
from onika.desk.environment.outcome.network_services import NetworkServices
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.run_state.run import Run
from onika.store.site import Site
from onika.wire import request
from onika.words.reason import Reason


class PartsRecorder(Protocol):
    """Who writes down a run at several stations; the file is that of the run's view."""

    def begin(self, run: Run, prepare: request.Prepare, begin: request.Begin) -> Reason:
        """A run is about to begin at its stations; why it cannot be recorded, NOTHING where it is."""
        ...

    def forget(self, run: Run) -> None:
        """It has not begun after all: nothing is left of its recording."""
        ...

    def close(self) -> None:
        """The program ends: so do recordings that go on."""
        ...


@dataclass(frozen=True, slots=True)
class Services:
    """The outside of an environment.

    site      where names are found
    clock     seconds that never go back
    calendar  seconds since 1970
    state     the directory of what outlives a session: diary and recovery; None: nothing does
    commands  runs the commands of buttons; None: they cannot be run
    reading   reads recordings; None: none can be looked at
    comparing compares them
    keeping   keeps runs as tests; None: none is kept
    meshing   makes the meshes that a page draws; None: none are made
    remote    what acts on libraries of others need; None: there are none
    player    the folder of the player of shared files; None: recordings are not shared
    network   what acts on other sites need; None: none are found
    recorder  writes down what is done at several stations; None: that is not recorded
    """

    site: Site
    clock: Callable[[], float]
    state: Path | None = None
    commands: Commands | None = None
    calendar: Callable[[], float] = time.time
    reading: BackgroundWorker | None = None
    comparing: BackgroundWorker | None = None
    keeping: BackgroundWorker | None = None
    meshing: BackgroundWorker | None = None
    remote: LibraryServices | None = None
    player: Path | None = None
    network: NetworkServices | None = None
    recorder: PartsRecorder | None = None
