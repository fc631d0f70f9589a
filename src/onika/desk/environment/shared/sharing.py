"""A recording becomes a file that plays by itself (requirement X21)."""

from dataclasses import dataclass
from pathlib import Path

from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.shared.meshes import meshes
from onika.desk.environment.shared.playing_page import Player, playing_page, room_for_document
from onika.desk.environment.shared.recorded_document import PERIODS_S, recorded_document
from onika.record.reader import UNREADABLE, flaw
from onika.store.mesh_folder import MeshFolder
from onika.store.site import Site
from onika.wire.view import Tree
from onika.words.reason import Reason

MOST_BYTES = 5_000_000
"""What a file may take where nobody says: what can be sent with a message."""


@dataclass(frozen=True, slots=True)
class SharedFile:
    """The file as text, and what is worth knowing of it."""

    text: str
    name: str
    """Of the run."""
    period_s: float
    """Between two instants that it shows, at most."""
    fits: bool
    """Whether it is as small as was wanted."""
    notes: tuple[Reason, ...]
    """Of the recording: that it was cut short, or shown without its icons."""

    @property
    def is_coarse(self) -> bool:
        """Whether its instants lie further apart than usual, so that it stays small."""
        return self.period_s > PERIODS_S[0]


def shared_file(
    subject: ReviewedRun, tree: Tree, site: Site, player: Path, most_bytes: int, folder: MeshFolder | None
) -> SharedFile | Reason:
    """The file of a recorded run that is looked at, or why there is none."""
    try:
        built = Player.read(player)
    except OSError:
        return Reason.of("desk.page_not_built")
    try:
        drawn = meshes(subject, site, folder)
        document = recorded_document(subject, tree, room_for_document(built, most_bytes), drawn)
    except UNREADABLE as wrong:
        return Reason.of("desk.recording_unseen", file=subject.path.name, why=flaw(wrong))
    text = playing_page(subject.view.name, document.content, built)
    return SharedFile(text, subject.view.name, document.period_s, document.fits, subject.view.notes)
