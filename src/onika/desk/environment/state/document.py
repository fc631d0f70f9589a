"""An open document: its content, its past, the file it came from and what of it lives (requirement C06)."""

from dataclasses import dataclass, replace

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.live import SubsystemFacts, TakenOver, WatchedRun
from onika.desk.environment.state.open_file import DocumentKind, OpenFile
from onika.model.configuration import Configuration


@dataclass(frozen=True, slots=True)
class Document(OpenFile[Configuration, Content]):
    """An open configuration."""

    kind = DocumentKind.CONFIGURATION
    content: Content
    live: SubsystemFacts | None = None
    """What is known of it in the running system; None: it is not connected."""
    watched: WatchedRun | None = None
    """The running application that it looks into, or looked into last."""
    taken: TakenOver | None = None
    """What a run has taken over of it; None: nothing."""
    station: str = ""
    """The station at which it is turned on; empty: the first one."""

    @property
    def name(self) -> str:
        """What it is called."""
        return self.content.configuration.name

    @property
    def value(self) -> Configuration:
        """What its file would hold if it were saved now."""
        return self.content.configuration

    @property
    def is_dirty(self) -> bool:
        """Whether it has changed in more than its looks since it was saved."""
        return self.content.configuration.meaning != self._saved.meaning

    @property
    def is_moved(self) -> bool:
        """Whether it has changed in its looks only."""
        return not self.is_dirty and self.content.configuration != self._saved

    @property
    def is_unsaved(self) -> bool:
        """Whether it has changed since it was saved, in its looks too, or one that is kept alive with it has."""
        return self.is_dirty or self.is_moved or any(kept.is_unsaved for kept in self.content.kept)

    @property
    def _saved(self) -> Configuration:
        if self.opened:
            return self.opened.value
        return Configuration(self.name)

    def means(self, content: Content) -> bool:
        """Whether other content differs from its own in looks only."""
        is_same = content.configuration.meaning == self.content.configuration.meaning
        return is_same and content.wanted == self.content.wanted

    def having(self, content: Content) -> "Document":
        """With other content."""
        return replace(self, content=content)
