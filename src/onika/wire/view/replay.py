"""A session that is replayed from its log, as a page shows it (requirement H08)."""

from onika.wire.view.view import View
from onika.words.reason import Reason


class ReplayView(View, frozen=True):
    """How far the replay of a session is, and the line that was carried out last, in the columns of the log."""

    file: str
    """The name of the log."""
    position: int
    """Lines that were carried out, of `count`."""
    count: int
    at_s: float = 0.0
    """Seconds of the session, which lasts `length_s`."""
    length_s: float = 0.0
    speed: float = 1.0
    """Seconds of the session in a second."""
    is_playing: bool = False
    event: str = ""
    object: str = ""
    id: str = ""
    associated: str = ""
    associated_id: str = ""
    window: str = ""
    faults: tuple[Reason, ...] = ()
    """What could not be done as it was, the newest; `faults_in_all` are all of them."""
    faults_in_all: int = 0
