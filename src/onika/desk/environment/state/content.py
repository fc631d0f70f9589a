"""What is in a document, as far as it is the user's and can be taken back."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.model.configuration import Configuration, Placed
from onika.store.opened_text import OpenedText


@dataclass(frozen=True, slots=True)
class KeptConfiguration:
    """A configuration whose tasks live, OFF, beside those of the one that is shown (requirement C32)."""

    configuration: Configuration
    opened: OpenedText[Configuration] | None = None
    """Its file, as it was read or written last."""
    base: Path | None = None

    @property
    def name(self) -> str:
        """What it is called."""
        return self.configuration.name

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its tasks, in order."""
        return self.configuration.names

    @property
    def is_unsaved(self) -> bool:
        """Whether it has changed in more than its looks since it was saved."""
        saved = self.opened.value if self.opened else Configuration(self.name)
        return self.configuration.meaning != saved.meaning


@dataclass(frozen=True, slots=True)
class Content:
    """A configuration, and what is wanted of its tasks in the running system (law 22)."""

    configuration: Configuration
    wanted: Mapping[str, bool] = field(default_factory=dict)
    """The tasks that are to live, and whether they are to be ON; none where nothing is connected."""
    kept: tuple[KeptConfiguration, ...] = ()
    """Further configurations that are kept alive: one act switches to them."""

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the tasks on the canvas, in order."""
        return self.configuration.names

    @property
    def union(self) -> tuple[str, ...]:
        """The names of all tasks that live where it is connected: those on the canvas, then those that are kept."""
        others = (name for kept in self.kept for name in kept.names)
        return tuple(dict.fromkeys((*self.names, *others)))

    def placed(self, name: str) -> Placed | None:
        """The task of that name: as it stands on the canvas, else as it is kept."""
        configurations = (self.configuration, *(kept.configuration for kept in self.kept))
        every = (placed for configuration in configurations for placed in configuration.placed)
        return next((placed for placed in every if placed.task == name), None)

    def with_configuration(self, configuration: Configuration) -> "Content":
        """With another configuration; tasks that are no longer in it are wanted no more, and in no supermodule.

        One that is kept lives on, OFF.
        """
        placed = set(configuration.names)
        alive = placed.union(*(kept.names for kept in self.kept))
        wanted = {name: is_on and name in placed for name, is_on in self.wanted.items() if name in alive}
        return replace(self, configuration=configuration.regrouped(configuration.groups), wanted=wanted)
