"""The runtimes of one application learn of each other: pacts are handed round, ways are measured (decision 56)."""

import secrets
import socket
from collections.abc import Callable, Generator, Sequence
from typing import cast

from onika.desk.plan.plan_parts import PlanPart, shared_tags
from onika.engine.rendezvous_terms import RendezvousTerms
from onika.link.address import is_near
from onika.wire.rendezvous_link import Linked, LinkedRuntime, LinkRuntimes, MeetingTerms, OfferPact, PactOffered
from onika.wire.request import Refused, Request, Response
from onika.words.reason import Reason
from onika.words.system_error import system_reason

AskEach = Callable[[Sequence[Request]], Sequence[Response]]
"""Asks each runtime its own request at one time."""
Linking = Generator[Sequence[Request], Sequence[Response], MeetingTerms | Reason]

_LOCAL, _ANY = "127.0.0.1", "0.0.0.0"  # noqa: S104  where datagrams of one run are heard, each sealed
_EXTRA_CLOCK_NS = 1_000_000


def link(parts: Sequence[PlanPart], titles: Sequence[str], hosts: Sequence[str], ask: AskEach) -> MeetingTerms | Reason:
    """The terms on which they meet, or why they cannot."""
    steps = linking(parts, titles, hosts)
    requests = next(steps)
    while True:
        try:
            requests = steps.send(ask(requests))
        except StopIteration as end:
            return cast("MeetingTerms | Reason", end.value)


def linking(parts: Sequence[PlanPart], titles: Sequence[str], hosts: Sequence[str]) -> Linking:
    """The same in steps: each yields what to ask every runtime at one time, and goes on with their responses."""
    are_near = all(map(is_near, hosts))
    offers = yield [OfferPact(_LOCAL if are_near else _ANY)] * len(parts)
    pacts = [offer for offer in offers if isinstance(offer, PactOffered)]
    if len(pacts) < len(parts):
        return _refusal(offers, titles)
    try:
        reached = [_reached(host, hosts) for host in hosts]
    except OSError as fault:
        return Reason.of("desk.cannot_meet_at", runtime=titles[0], why=system_reason(fault))
    answers = yield _introduced(parts, titles, reached, pacts)
    linked = [answer for answer in answers if isinstance(answer, Linked) and not answer.refusal]
    if len(linked) < len(parts):
        return _refusal(answers, titles)
    ways = [way for answer in linked for way in answer.ways]
    clock_ns = max(way.clock_ns for way in ways) * 5 // 4 + _EXTRA_CLOCK_NS
    return MeetingTerms(max(way.trip_ns for way in ways) // 2, clock_ns)


def _introduced(
    parts: Sequence[PlanPart], titles: Sequence[str], hosts: Sequence[str], pacts: Sequence[PactOffered]
) -> list[LinkRuntimes]:
    """What each is told of all others."""
    runtimes = [
        LinkedRuntime(site, title, host, pact.port, pact.name, pact.key, pact.epoch)
        for site, (title, host, pact) in enumerate(zip(titles, hosts, pacts, strict=True))
    ]
    run, tags = secrets.token_bytes(16), shared_tags(parts)
    return [
        LinkRuntimes(run, runtime.site, tuple(other for other in runtimes if other is not runtime), tags)
        for runtime in runtimes
    ]


def note(terms: MeetingTerms, titles: Sequence[str | Reason]) -> Reason:
    """What whoever begins the run has to know of it."""
    alone_ms = RendezvousTerms(terms.one_way_ns, terms.clock_ns).alone_ns / 1e6
    return Reason.of("desk.meets_on_terms", runtimes=tuple(titles), clock_ms=terms.clock_ns / 1e6, alone_ms=alone_ms)


def _refusal(answers: Sequence[Response], titles: Sequence[str]) -> Reason:
    for answer, title in zip(answers, titles, strict=True):
        if isinstance(answer, Refused):
            return Reason.of("desk.cannot_meet_at", runtime=title, why=answer.reason)
        if isinstance(answer, Linked) and answer.refusal:
            return Reason.of("desk.cannot_meet_at", runtime=title, why=answer.refusal)
    return Reason.of("desk.cannot_meet_at", runtime=titles[0], why=str(answers[0]))


def _reached(host: str, hosts: Sequence[str]) -> str:
    """Where others reach a runtime: one on this machine by the address that this machine has towards them."""
    if not is_near(host):
        return host
    far = next((other for other in hosts if not is_near(other)), "")
    if not far:
        return _LOCAL
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:  # nothing is sent
        probe.connect((far, 9))
        return str(probe.getsockname()[0])
