"""What a user does to what is his own: preferences, buttons, diary."""

from typing import Any, Literal

from onika.wire.act.act import Act


class Prefer(Act, frozen=True):
    """Change preferences, by their names (§A.5); replied with those refused."""

    values: dict[str, Any]


class Press(Act, frozen=True):
    """Run the command of a user's button."""

    name: str


class Halt(Act, frozen=True):
    """End the command of a user's button."""

    name: str


class SetButton(Act, frozen=True):
    """Add a button or change it; an empty command removes it."""

    name: str
    command: str
    spawns_terminal: bool = False


class SteerReplay(Act, frozen=True):
    """Play, pause or step the session that is replayed, or go to its end (H08); where none is, it is refused."""

    wish: Literal["play", "pause", "step", "end"]
    speed: float = 0.0
    """Seconds of the session in a second; 0: as before."""


class Note(Act, frozen=True):
    """What the page alone knows of: a selection, a view opened (H01); into the diary, no step."""

    event: str
    object: str = ""
    id: str = ""
    associated: str = ""
    associated_id: str = ""
    window: str = ""
