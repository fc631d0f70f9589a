"""A visitor of the page: who looks at it, and what he may do there."""

from dataclasses import dataclass

from onika.link.caller import Role


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
