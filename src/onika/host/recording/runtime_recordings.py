"""Everything that one runtime writes down: runs, what is held by hand, the last seconds of what goes badly."""

from collections.abc import Callable
from pathlib import Path

from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording.black_box import BlackBox
from onika.host.recording.black_box_holder import BlackBoxHolder
from onika.host.recording.hand_held import HandHeld
from onika.host.recording.hand_recordings import HandRecordings
from onika.host.recording.recorded_worlds import RecordedDriver
from onika.host.recording.recorder import Recorder
from onika.host.recording.run_description import RunDescriptions
from onika.host.run.application_run import ApplicationRun
from onika.host.sessions.request_server import RequestServer
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.record.black_box_folder import clear_unfinished
from onika.wire import event, request


class RuntimeRecordings:
    """The recorder of runs, the recordings that are begun by hand, and the black box where one is kept."""

    def __init__(self, subsystems: Subsystems, driver: RecordedDriver, server: RequestServer) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._server = server
        self.descriptions = RunDescriptions(subsystems, driver)
        self.recorder = Recorder(subsystems, driver, server, self.descriptions)
        self.by_hand = HandRecordings(subsystems, driver, self.descriptions, server.tell)
        self.black_box: BlackBox | None = None
        self._hand_held: HandHeld | None = None
        server.overhear(self.by_hand.hear)

    def keep_last_seconds(
        self, folder: Path, holder: BlackBoxHolder, make_holder: Callable[[], BlackBoxHolder]
    ) -> None:
        """From now on the last seconds of what goes badly are written into this folder."""
        clear_unfinished(folder)
        black_box = self.black_box = BlackBox(folder, holder, make_holder, self._subsystems, self._driver)
        hand_held = HandHeld(black_box, self._subsystems, self.descriptions, self._driver, self._server.tell)
        self._hand_held = hand_held
        self._server.overhear(hand_held.hear)

    def readers(self) -> list[ProcessSocket]:
        """What to wait for: whoever writes."""
        black_box = self.black_box.readers() if self.black_box is not None else ()
        return [*self.recorder.readers(), *self.by_hand.readers(), *black_box]

    def due_ns(self) -> int | None:
        """In how many nanoseconds something is to be written that nobody calls for; None: never."""
        return None if self._hand_held is None else self._hand_held.due_ns()

    def serve(self) -> None:
        """Take in what has come; write what is due."""
        self.recorder.serve()
        self.by_hand.serve()
        if self.black_box is not None and self._hand_held is not None:
            self._hand_held.serve()
            self.black_box.serve()

    def command(self, session: str, message: request.Request) -> None:
        """Something was carried out."""
        self.recorder.command(session, message)
        self.by_hand.command(session, message)
        if self.black_box is not None:
            self.black_box.command(session, message)

    def end(self, run: ApplicationRun, result: event.Result) -> str | None:
        """A run is through: the path of its black box, or empty; None while something is still to be written."""
        if not self.recorder.may_end(run, result):
            return None
        return "" if self.black_box is None else self.black_box.end(run, result)

    def lost(self, session: str) -> None:
        """A session is gone."""
        self.descriptions.lost(session)
        self.recorder.lost(session)

    def finish(self) -> None:
        """The runtime ends: what is still to be written is written."""
        self.by_hand.finish()
        if self.black_box is not None and self._hand_held is not None:
            self._hand_held.finish()
            self.black_box.finish()

    def leave(self) -> None:
        """Another program goes on, on the same links: finish, and hear nothing more."""
        self.finish()
        self._server.leave(self.by_hand.hear)
        if self._hand_held is not None:
            self._server.leave(self._hand_held.hear)
