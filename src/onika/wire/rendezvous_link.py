"""How runtimes that carry out flows of one application learn of each other, before the run (decision 56).

The environment asks each for a pact, hands all of them round, and begins the run when all have heard each other. It is
not needed after that.
"""

from typing import Annotated

from msgspec import Meta, Struct

from onika.words.reason import NOTHING, Reason

Site = Annotated[int, Meta(ge=0, le=255)]
"""The number of a runtime in a run, from 0: the order of their lowest flows."""

Span = Annotated[int, Meta(ge=0, le=10_000_000_000)]
"""A time, in ns."""


class OfferPact(Struct, frozen=True, tag=True):
    """Be ready to hear from the other runtimes of a run at this address of the machine; replied by PactOffered."""

    host: str = "127.0.0.1"


class PactOffered(Struct, frozen=True, tag=True):
    """Where the runtime hears, and with which pact; `epoch` is that of its life, for this run."""

    port: int
    name: bytes
    key: bytes
    epoch: int


class LinkedRuntime(Struct, frozen=True):
    """Another runtime of the run: its name for people, where it hears, its pact and its epoch."""

    site: Site
    title: str
    host: str
    port: int
    name: bytes
    key: bytes
    epoch: int


class SharedTag(Struct, frozen=True):
    """A synchronisation tag of the plan, and the runtimes that have flows that meet there."""

    tag: str
    sites: tuple[Site, ...]


class LinkRuntimes(Struct, frozen=True, tag=True):
    """These are the other runtimes of a run, whose number has 16 bytes; replied by Linked when all were heard."""

    run: bytes
    site: Site
    partners: tuple[LinkedRuntime, ...]
    tags: tuple[SharedTag, ...]


class Way(Struct, frozen=True):
    """How far another runtime is: its quickest round trip, and by how much its clock may be misjudged, in ns.

    -1: it was not heard.
    """

    site: int
    trip_ns: int
    clock_ns: int


class Linked(Struct, frozen=True, tag=True):
    """The ways to all others; `refusal` says why the runtimes cannot meet, where that is so."""

    ways: tuple[Way, ...]
    refusal: Reason = NOTHING


class MeetingTerms(Struct, frozen=True):
    """The terms on which the runtimes of a run meet, the same for all: those of the worst way, in ns."""

    one_way_ns: Span
    clock_ns: Span


RendezvousRequest = OfferPact | LinkRuntimes
RendezvousResponse = PactOffered | Linked
