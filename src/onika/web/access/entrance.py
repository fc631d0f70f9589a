"""The entrance of the page: who sends a request, and whether it is meant for us and comes from a page of ours."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from onika.link.caller import Role
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Visitor:
    """Somebody who was let in.

    user        his name; empty: whoever had the key of this machine
    session     names what he came in by, so that it can be ended; no secret
    address     from where he came in
    """

    user: str
    role: Role
    session: str = ""
    address: str = ""


OWNER = Visitor("", Role.OWNER)
"""Whoever has the key that was printed on this machine."""


class Entrance(Protocol):
    """Whatever lets browsers in: the key of this machine, or names and passwords."""

    @property
    def closed(self) -> Reason:
        """What is said to whoever was not let in."""
        ...

    def is_ours(self, headers: Mapping[str, str]) -> bool:
        """Whether a request names us as its host: a foreign name that leads here does not (DNS rebinding)."""
        ...

    def is_own_page(self, headers: Mapping[str, str]) -> bool:
        """Whether it is sent by a page that came from here."""
        ...

    def visitor(self, cookies: Mapping[str, str]) -> Visitor | None:
        """Who that is, by his cookie; None: somebody who was not let in."""
        ...
