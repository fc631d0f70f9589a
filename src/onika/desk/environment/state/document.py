"""An open document: its content, its past, the file it came from and what of it lives (requirement C06)."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.history import History, Step
from onika.desk.environment.state.live import Live
from onika.model.configuration import Configuration
from onika.store.opened_text import OpenedText


@dataclass(frozen=True, slots=True)
class Document:
    """An open configuration."""

    id: str
    content: Content
    history: History[Step] = field(default_factory=History)
    opened: OpenedText[Configuration] | None = None
    """The file as it was read or saved last; None: it has none yet."""
    base: Path | None = None
    """The base directory of its file."""
    has_changed_on_disk: bool = False
    live: Live | None = None
    """What is known of it in the running system; None: it is not connected."""

    @property
    def name(self) -> str:
        """What it is called."""
        return self.content.configuration.name

    @property
    def is_dirty(self) -> bool:
        """Whether it has changed in more than its looks since it was saved."""
        return _meaning(self.content.configuration) != _meaning(self._saved)

    @property
    def is_moved(self) -> bool:
        """Whether it has changed in its looks only."""
        return not self.is_dirty and self.content.configuration != self._saved

    @property
    def _saved(self) -> Configuration:
        return self.opened.value if self.opened else Configuration(self.name)

    def having(self, content: Content) -> "Document":
        """With other content."""
        return replace(self, content=content)


def _meaning(configuration: Configuration) -> tuple[Mapping[str, tuple[float, str]], Mapping[str, tuple[str, ...]]]:
    """A configuration without its looks: which tasks, at which rate, on which unit, and its supermodules."""
    tasks = {placed.task: (placed.frequency, placed.rtpu) for placed in configuration.placed}
    return tasks, {group.name: group.tasks for group in configuration.groups}
