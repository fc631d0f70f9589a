"""Offers: a holder would hand a subsystem over to another session, which takes it or not (requirement X12)."""

from dataclasses import dataclass

from onika.host.subsystems.subsystem_registry import Tell
from onika.wire import event
from onika.words.reason import Reason

LASTS_NS = 60_000_000_000
"""How long an offer stands."""


@dataclass(frozen=True, slots=True)
class Offer:
    """What is offered by whom to whom, and until when."""

    subsystem: str
    holder: str
    to: str
    until_ns: int


class Offers:
    """At most one for each subsystem; both sides are told of each, and of its end."""

    def __init__(self, tell: Tell) -> None:
        self._tell = tell
        self._offers: dict[str, Offer] = {}

    def put(self, subsystem: str, holder: str, to: str, now_ns: int) -> None:
        """Offer it, in place of what was offered before."""
        self.end(subsystem, Reason.of("host.offer_withdrawn"))
        self._offers[subsystem] = Offer(subsystem, holder, to, now_ns + LASTS_NS)
        self._tell(event.Offered(subsystem, holder, to), subsystem, to)

    def find(self, subsystem: str) -> Offer | None:
        """What is offered of it."""
        return self._offers.get(subsystem)

    def end(self, subsystem: str, outcome: Reason) -> None:
        """It is offered no more."""
        offer = self._offers.pop(subsystem, None)
        if offer is not None:
            self._tell(event.Offered(subsystem, offer.holder, offer.to, outcome), subsystem, offer.holder)

    def leave(self, session: str) -> None:
        """A session is gone: it offers nothing and takes nothing."""
        for offer in list(self._offers.values()):
            if session in (offer.holder, offer.to):
                self.end(offer.subsystem, Reason.of("host.offer_deserted", session=session))

    def expire(self, now_ns: int) -> None:
        """Let time pass."""
        for offer in list(self._offers.values()):
            if now_ns >= offer.until_ns:
                self.end(offer.subsystem, Reason.of("host.offer_unanswered", seconds=LASTS_NS * 1e-9))
