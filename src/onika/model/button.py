"""A button of the user's own that runs a command (dissertation §5.7.2, §A.6)."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Button:
    """The name on the button, the command it runs and whether that runs in a terminal of its own."""

    name: str
    command: str
    spawns_terminal: bool = False
