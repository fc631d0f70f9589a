"""The recordings of this environment, black boxes among them, newest first (requirement X05)."""

from collections.abc import Iterator, Set
from datetime import datetime
from pathlib import Path

from onika.desk.environment.file.recordings_folder import ENDING, recordings_folder
from onika.desk.environment.outcome.outcome import Done, Procedure, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.review.opening import NOT_HERE
from onika.desk.environment.state.model import Model
from onika.record.black_box_folder import black_boxes_in
from onika.record.reader import UNREADABLE
from onika.record.summary import summary
from onika.wire import act
from onika.wire.view import RecordingFile, RecordingsView


def recordings(model: Model, _asked: act.Recordings, outside: Services) -> Procedure:
    """Which there are; the value is a `view.RecordingsView`. One that is being made is not among them."""
    if outside.state is None or outside.reading is None:
        return NOT_HERE
    folder, boxes = recordings_folder(outside.state), black_boxes_in(outside.state)
    by_hand = {document.live.recording for document in model.documents.values() if document.live is not None}
    made = {run.view.recording for run in model.going} | by_hand
    model, files = yield Work(model, outside.reading, lambda: _newest_first(folder, boxes, made))
    return Done(model, value=RecordingsView(str(folder), files))


def _newest_first(folder: Path, boxes: Path, made: Set[str]) -> tuple[RecordingFile, ...]:
    files = [file for place in (folder, boxes) for file in _files(place, made)]
    return tuple(sorted(files, key=lambda file: file.began_at_s, reverse=True))


def _files(folder: Path, made: Set[str]) -> Iterator[RecordingFile]:
    for path in folder.glob(f"*{ENDING}"):
        if str(path) not in made:
            try:
                recording = summary(path)
                began_at_s = datetime.fromisoformat(recording.began).timestamp()
                size = path.stat().st_size
            except UNREADABLE:
                continue  # something else that lies there, or that has gone
            yield RecordingFile(
                str(path),
                recording.application,
                began_at_s,
                recording.lasted_s,
                size,
                recording.is_whole,
                recording.is_black_box,
            )
