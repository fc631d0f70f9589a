"""The entrance of the page: who sends a request, and whether it is meant for us and comes from a page of ours."""

from collections.abc import Mapping
from typing import Protocol

from onika.web.access.visitor import Visitor


class Entrance(Protocol):
    """Whatever lets browsers in: the key of this machine, or names and passwords."""

    def is_ours(self, headers: Mapping[str, str]) -> bool:
        """Whether a request names us as its host: a foreign name that leads here does not (DNS rebinding)."""
        ...

    def is_own_page(self, headers: Mapping[str, str]) -> bool:
        """Whether it is sent by a page that came from here."""
        ...

    def visitor(self, cookies: Mapping[str, str]) -> Visitor | None:
        """Who that is, by his cookie; None: somebody who was not let in."""
        ...
