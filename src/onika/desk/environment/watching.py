"""What the browsers together want to see of the running system, and what is asked of a runtime for it."""

from dataclasses import dataclass
from math import isnan

from onika.desk.environment.model import Model
from onika.wire import live

FASTEST_HZ = 60.0
_SLOWEST_HZ = 0.1


@dataclass(frozen=True, slots=True)
class Watching:
    """A wish: variables as `DOC/NAME`, worlds by name, figures of all tasks, and how often at most."""

    variables: frozenset[str] = frozenset()
    worlds: frozenset[str] = frozenset()
    figures: bool = False
    hz: float = 0.0

    def attend(self, model: Model) -> live.Attend:
        """What is asked of the runtime with which the documents of this model are connected."""
        homes = homes_of(model)
        keys = [key.partition("/") for key in sorted(self.variables)]
        readings = tuple(f"{homes[doc]}/{name}" for doc, _, name in keys if doc in homes and name)
        hz = _SLOWEST_HZ if isnan(self.hz) else min(max(self.hz, _SLOWEST_HZ), FASTEST_HZ)
        return live.Attend(("*",), readings, tuple(sorted(self.worlds)), hz)


def homes_of(model: Model) -> dict[str, str]:
    """The subsystems of the documents that are connected, by their ids."""
    return {
        doc: one.live.subsystem
        for doc, one in model.documents.items()
        if one.live is not None and one.live.state == "live"
    }
