"""Writes down runs whose flows are carried out at several stations: none of their runtimes knows all of it (X05, E12).

A run at one station is recorded by its runtime. Of one at several the environment is the first who hears everything.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct, structs

from onika.desk.environment.environment import Environment
from onika.desk.environment.reconcile.run_reducer import meant
from onika.desk.environment.run_state import run_parts
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.model import Model
from onika.record.run import HERE
from onika.wire import event, page, request
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

if TYPE_CHECKING:
    from onika.desk.joined.joint_recording import JointRecording


class RunRecorder:
    """Hears what the runtimes tell, before it changes anything."""

    def __init__(self) -> None:
        self._environment: Environment | None = None
        self._recordings: dict[int, JointRecording] = {}
        """By the numbers of their runs."""
        self._paths: dict[int, Path] = {}

    def attend(self, environment: Environment) -> None:
        """Hear what this environment hears from now on."""
        self._environment = environment
        environment.listening.append(self.hear)
        environment.measuring.append(self.read)
        environment.followers.append(self.follow)

    def begin(self, run: Run, prepare: request.Prepare, begin: request.Begin) -> Reason:
        """A run is about to begin at its stations; why it cannot be recorded, NOTHING where it is."""
        from onika.desk.joined.joint_recording import JointRecording  # within: few ever need it

        stations = {home: run.station_of(home) or HERE for home in run.homes}
        path = Path(run.view.recording)
        try:
            recording = JointRecording(prepare, structs.replace(begin, record=str(path)), stations)
        except OSError as wrong:
            return system_reason(wrong)
        self._recordings[run.view.number], self._paths[run.view.number] = recording, path
        return NOTHING

    def forget(self, run: Run) -> None:
        """It has not begun after all: nothing is left of its recording."""
        recording = self._recordings.pop(run.view.number, None)
        if recording is not None:
            recording.close()
            self._paths.pop(run.view.number).unlink(missing_ok=True)

    def hear(self, station: str, asked: str, message: Struct) -> None:
        """The runtime of a station has told something, or replied to what was asked."""
        environment = self._environment
        if environment is None or asked or not self._recordings or not isinstance(message, event.Event):
            return
        run = meant(environment.model.at(station), message)
        recording = None if run is None else self._recordings.get(run.view.number)
        if run is None or recording is None:
            return
        _, whole = run_parts.of_whole(run, message, station)
        if whole is None:
            return  # the end of a part
        if getattr(whole, "run", ""):
            whole = structs.replace(whole, run=run.homes[0])
        recording.hear(whole)
        if isinstance(whole, event.Result):
            self._end(run.view.number)

    def read(self, station: str, readings: Mapping[str, bytes]) -> None:
        """What variables hold at a station, by `SUBSYSTEM/NAME`."""
        going = self._environment.model.at(station).going_here if self._environment is not None else ()
        for run in going:
            recording = self._recordings.get(run.view.number)
            if recording is not None:
                homes = run.homes_at(station)
                recording.read({key: body for key, body in readings.items() if key.rpartition("/")[0] in homes})

    def follow(self, _before: Model, after: Model) -> None:
        """A run that goes on no more has come to its end without one of its runtimes saying so."""
        if self._recordings:
            going = {run.view.number for run in after.going}
            for number in [number for number in self._recordings if number not in going]:
                causes = [run.view.cause for run in after.every_run if run.view.number == number]
                self._end(number, next(iter(causes), NOTHING) or NOTHING)

    def close(self) -> None:
        """The program ends."""
        for number in list(self._recordings):
            self._end(number)

    def _end(self, number: int, cause: Reason = NOTHING) -> None:
        recording = self._recordings.pop(number)
        self._paths.pop(number)
        recording.close(cause)
        if recording.reason and self._environment is not None:
            self._environment.say(page.Say("warning", Reason.of("host.recording_not_whole", why=recording.reason)))
