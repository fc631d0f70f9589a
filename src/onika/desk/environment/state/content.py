"""What is in a document, as far as it is the user's and can be taken back."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from onika.model.configuration import Configuration, Placed


@dataclass(frozen=True, slots=True)
class Content:
    """A configuration, and what is wanted of its tasks in the running system (law 22)."""

    configuration: Configuration
    wanted: Mapping[str, bool] = field(default_factory=dict)
    """The tasks that are to live, and whether they are to be ON; none where nothing is connected."""

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the tasks, in order."""
        return tuple(placed.task for placed in self.configuration.placed)

    def placed(self, name: str) -> Placed | None:
        """The task of that name."""
        return next((placed for placed in self.configuration.placed if placed.task == name), None)

    def with_configuration(self, configuration: Configuration) -> "Content":
        """With another configuration; tasks that are no longer in it are wanted no more, and in no supermodule."""
        names = {placed.task for placed in configuration.placed}
        wanted = {name: is_on for name, is_on in self.wanted.items() if name in names}
        return replace(self, configuration=configuration.regrouped(configuration.groups), wanted=wanted)
