"""The keys that steer a run: each becomes a command line for the selected flow (requirement E07)."""

from dataclasses import dataclass, field

from prompt_toolkit.keys import Keys

from onika.words.reason import Reason

KEYS = {
    "p": ("pause", Reason.of("cli.key_pause")),
    "c": ("continue", Reason.of("cli.key_continue")),
    "s": ("step", Reason.of("cli.key_step")),
    "n": ("next", Reason.of("cli.key_next")),
    "r": ("pass", Reason.of("cli.key_pass")),
    "l": ("leave", Reason.of("cli.key_leave")),
    "e": ("clear", Reason.of("cli.key_clear")),
    "a": ("abort", Reason.of("cli.key_abort")),
    "w": ("who", Reason.of("cli.key_who")),
}
"""Key, word of steering, what it says on the panel."""

SHORT = {
    "p": Reason.of("cli.key_pause"),
    "c": Reason.of("cli.key_continue"),
    "s": Reason.of("cli.key_step"),
    "n": Reason.of("cli.key_next_short"),
    "e": Reason.of("cli.key_clear_short"),
    "a": Reason.of("cli.key_abort"),
    "?": Reason.of("cli.key_more"),
}
"""The keys that the panel always names, in short."""


@dataclass(slots=True)
class KeyBindings:
    """Which flow is chosen (all, where none is), and what is being typed."""

    flows: tuple[str, ...] = ()
    chosen: int | None = None
    has_help: bool = False
    typed: str | None = None
    """The line that is typed; None: none is."""
    lines: list[str] = field(default_factory=list)
    """What is wanted and was not taken yet."""

    def press(self, key: str) -> None:
        """Take in a key."""
        if self.typed is not None:
            self._type(key)
        elif key in KEYS:
            self._want(KEYS[key][0])
        elif key == "b":
            self.typed = f"break {self._flow}".strip() + " "
        elif key == ":":
            self.typed = ""
        elif key == "?":
            self.has_help = not self.has_help
        elif key.isdigit() and int(key) < len(self.flows) and len(self.flows) > 1:
            self.chosen = None if self.chosen == int(key) else int(key)

    def take(self) -> list[str]:
        """The lines that are wanted now."""
        taken, self.lines = self.lines, []
        return taken

    @property
    def _flow(self) -> str:
        if self.chosen is None:
            return ""
        return self.flows[self.chosen]

    def _want(self, word: str) -> None:
        takes_flow = word not in ("abort", "who")
        self.lines.append(f"{word} {self._flow}".strip() if takes_flow else word)

    def _type(self, key: str) -> None:
        text = self.typed or ""
        match key:
            case Keys.ControlM | Keys.ControlJ:  # Enter
                self.lines += [text.strip()] if text.strip() else []
                self.typed = None
            case Keys.Backspace:
                self.typed = text[:-1] if text else None
            case Keys.ControlU:
                self.typed = ""
            case _ if len(key) == 1:
                self.typed = text + key
