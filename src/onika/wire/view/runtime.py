"""The runtime, as a page shows it."""

from typing import Literal

from msgspec import field

from onika.wire.view.view import View


class UnitView(View, frozen=True):
    """A processing unit."""

    load: float = 0.0
    is_lost: bool = False


class SessionView(View, frozen=True):
    """Somebody who is connected with the runtime; a user may be there several times."""

    role: str
    is_here: bool = True
    """Whether it is heard at present."""
    only_watches: bool = False
    is_you: bool = False


class RuntimeView(View, frozen=True):
    """The runtime of this environment."""

    state: Literal["none", "starting", "linked", "lost"] = "none"
    address: str = ""
    text: str = ""
    """Why it is lost."""
    is_virtual: bool = False
    is_stopped: bool = False
    stop_text: str = ""
    units: dict[str, UnitView] = field(default_factory=dict)
    worlds: dict[str, bool] = field(default_factory=dict)
    subsystems: dict[str, str] = field(default_factory=dict)
    """Names of those that live, with what holds them."""
    sessions: dict[str, SessionView] = field(default_factory=dict)
    """Who is there, by name."""
