"""How an environment is to begin."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, slots=True)
class EnvironmentOptions:
    """How an environment is to begin.

    files           configurations to open
    url, token      a runtime that runs already; empty: one of its own
    stations        further runtimes, each with its name, address and token
    is_connected    whether what is opened is connected at once
    is_virtual      whether runtimes that are started here are simulators, whose time passes as on the wall
    is_upper_only   whether the lower level is hidden in this session, whatever is preferred (G05)
    """

    files: tuple[str, ...] = ()
    url: str = ""
    token: str = ""
    stations: tuple[tuple[str, str, str], ...] = ()
    is_connected: bool = True
    rtpus: tuple[str, ...] = ("rt0",)
    with_fifo: bool = True
    has_black_box: bool = True
    is_virtual: bool = False
    has_diary: bool = True
    foresees: bool = True
    """Whether what open applications would come to is foreseen while they are edited (E16)."""
    is_upper_only: bool = False
    may_repose: bool = False
    """Whether it costs next to nothing, and its simulator rests, while nobody does anything and nothing runs (X25)."""
    dictionaries: tuple[Path, ...] = ()
    """The base directories whose dictionaries are open at first; none named: all of the search path."""
    presentation: str = ""
    """How icons are presented in this session; empty: as each browser likes (H04)."""

    def settings(self, surroundings: Mapping[str, str]) -> Mapping[str, str]:
        """What the system says of this session in its variables, and what was asked for when it was begun."""
        wanted: dict[str, str] = {}
        if self.is_upper_only:
            wanted["ONIKA_LOWER"] = "no"
        if self.presentation:
            wanted["ONIKA_PRESENTATION"] = self.presentation
        return {**surroundings, **wanted}
