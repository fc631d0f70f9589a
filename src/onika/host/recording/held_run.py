"""A run whose last seconds are held: a recording of them is written where it ends badly (requirement X05)."""

from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO

from onika.host.recording.black_box_orders import BlackBoxWritten, OpenBlackBox
from onika.host.recording.last_seconds import LastSeconds
from onika.record.black_box_folder import write_black_box
from onika.record.run import RunRecord
from onika.words.reason import NOTHING, reason_of


class HeldRun:
    """The last seconds of one run, and where they are written if it ends badly."""

    def __init__(self, order: OpenBlackBox, run: RunRecord) -> None:
        self.order = order
        self.last_seconds = LastSeconds()
        self.run = run

    def look(self, now: int) -> None:
        """Look at the variables; the time is that of the clock by which the run began."""
        self.last_seconds.look(now - self.order.began_ns)

    def write(self, words: Mapping[str, str], elsewhere: str = "") -> BlackBoxWritten:
        """Write them where they belong at the end of the run, or elsewhere; how that went."""
        path = elsewhere or self.order.path

        def write(stream: BinaryIO) -> None:
            self.last_seconds.write(stream, self.run, words)

        try:
            write_black_box(Path(path), write)
        except OSError as wrong:
            return BlackBoxWritten(self.order.number, reason_of(wrong), path)
        return BlackBoxWritten(self.order.number, NOTHING, path)
