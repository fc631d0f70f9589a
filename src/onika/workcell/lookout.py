"""A lookout: it watches a simulated world for what no program means (requirement E16).

It looks at the contacts again and again. A hand may touch the box that it takes, and a box that is carried what it is
taken from and put on; whatever else an arm, a hand or what it carries touches is a mishap, and so is a hand that closes
on nothing, loses its box or drops one on the floor.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from onika.laws.frames import Array
from onika.ring.device import MishapEvent
from onika.words.reason import Reason
from onika.workcell.carriage import APART_M, Carriage
from onika.workcell.contacts import Contact, Contacts, Thing
from onika.workcell.plant import Plant
from onika.workcell.watched_hand import WatchedHand

MOST = 50
"""Mishaps that are told of one world; one that has so many needs no more of them."""

_EVERY_NS = 8_000_000  # how often it looks: what touches something is not gone again sooner
_AGAIN_NS = 500_000_000  # how long two things were apart that meet anew

Advance = Callable[[Any, Any], None]
Pair = tuple[Thing, Thing]


def with_looks(advance: Advance, look: Callable[[int], None], now: Callable[[], int]) -> Advance:
    """What makes a step, and looks every 8 ms of the world's time."""
    due_ns = now() + _EVERY_NS

    def step(model: Any, data: Any) -> None:
        nonlocal due_ns
        advance(model, data)
        now_ns = now()
        if now_ns >= due_ns:
            due_ns = now_ns + _EVERY_NS
            look(now_ns)

    return step


class Lookout:
    """Watches one world, compiled as often as it is.

    devices_of  the devices at a side that are in use
    lit         what shines just now
    """

    def __init__(self, devices_of: Callable[[str], tuple[str, ...]], lit: Callable[[], tuple[str, ...]]) -> None:
        self._devices_of = devices_of
        self._lit = lit
        self._told = 0
        self._mishaps: list[MishapEvent] = []
        self._felt: dict[Pair, int] = {}
        """When two things that touch, or did, were felt last."""
        self._carriages: dict[Pair, Carriage] = {}
        self._carrier: dict[Thing, str] = {}
        """The side of the hand in which each box was last."""
        self._hands: tuple[WatchedHand, ...] = ()

    def watch(
        self,
        plant: Plant,
        sides: Sequence[str],
        advance: Advance,
        now: Callable[[], int],
        carried: Callable[[str], Iterable[str]] | None = None,
    ) -> Advance:
        """Look at this plant again and again from now on; gives what makes a step and looks.

        carried     the signs of the boxes in the hand of a side, where no forces hold them there
        """
        contacts = Contacts(plant)
        self._plant, self._contacts, self._carried = plant, contacts, carried
        self._hands = tuple(WatchedHand(plant, contacts, side, now()) for side in sides)
        self._is_alone = len(sides) < 2
        self._carriages.clear()
        self._look(now(), is_first=True)
        return with_looks(advance, self._look, now)

    def take(self) -> list[MishapEvent]:
        """What has happened since the last call, in the order in which it was understood."""
        mishaps, self._mishaps = self._mishaps, []
        return mishaps

    def _look(self, now_ns: int, *, is_first: bool = False) -> None:
        touching = self._touching()
        for hand in self._hands:
            hand.look(self._squeezed(hand, touching), now_ns)
        held = {box: hand.thing.name for hand in self._hands for box in hand.held}
        if held:
            self._carrier.update(held)
            touching = self._contacts.touching(held, is_deep=self._carried is not None)
        pairs = {(contact.one, contact.other) for contact in touching if not self._is_meant(contact, now_ns)}
        self._carry(pairs, now_ns)
        for pair in sorted(pairs):
            is_new = now_ns - self._felt.get(pair, -_AGAIN_NS) >= _AGAIN_NS
            self._felt[pair] = now_ns
            if is_new and not is_first:
                self._judge(pair, now_ns)
        self._look_at_hands(now_ns)

    def _touching(self) -> list[Contact]:
        if self._carried is None:
            return self._contacts.touching()
        self._contacts.collide()
        return self._contacts.touching(is_deep=True)

    def _squeezed(self, hand: WatchedHand, touching: list[Contact]) -> list[Thing]:
        if self._carried is None:
            return hand.squeezed(touching)
        return [Thing("box", sign) for sign in self._carried(hand.thing.name)]

    def _is_meant(self, contact: Contact, now_ns: int) -> bool:
        """Whether a hand touches a box as one that takes it does."""
        return contact.other.kind == "box" and any(
            hand.thing == contact.one and hand.means(contact, now_ns) for hand in self._hands
        )

    def _judge(self, pair: Pair, now_ns: int) -> None:
        """Two things meet that were apart: whether that is told at once."""
        one, other = pair
        if one.moves and other.moves:
            self._tell("workcell.meets", pair, now_ns)
        elif one.moves:
            self._tell("workcell.touches", pair, now_ns)
        elif other.kind == "floor" and pair not in self._carriages and self._carrying(pair) is None:
            sides = (self._carrier[one],) if one in self._carrier else ()
            self._note(Reason.of("workcell.falls", what=self._text(one)), sides, now_ns)

    def _tell(self, key: str, pair: Pair, now_ns: int) -> None:
        one, other = pair
        sides = tuple(dict.fromkeys(thing.name for thing in pair if thing.moves))
        self._note(Reason.of(key, who=self._text(one), what=self._text(other)), sides, now_ns)

    # What is carried

    def _carrying(self, pair: Pair) -> tuple[WatchedHand, Thing, Thing] | None:
        """The hand that has one of two things that are in no hand both, that one, and the other."""
        for box, other in (pair, pair[::-1]):
            for hand in self._hands:
                if box in hand.held and other not in hand.held:
                    return hand, box, other
        return None

    def _carry(self, pairs: Iterable[Pair], now_ns: int) -> None:
        for pair in pairs:
            carrying = self._carrying(pair)
            if carrying is not None and not carrying[2].moves and pair not in self._carriages:
                self._carriages[pair] = self._begun(*carrying, now_ns)
        for pair, carriage in list(self._carriages.items()):
            self._follow(pair, carriage, now_ns, touches=pair in pairs)

    def _begun(self, hand: WatchedHand, box: Thing, other: Thing, now_ns: int) -> Carriage:
        place = self._contacts.place(box)
        is_lifted = float(np.linalg.norm(place - hand.held[box])) < APART_M
        return Carriage(now_ns, self._poses(), self._lit(), place, self._place_of(other), is_lifted, now_ns)

    def _follow(self, pair: Pair, carriage: Carriage, now_ns: int, *, touches: bool) -> None:
        carrying = self._carrying(pair)
        if carrying is None:  # it was let go: that is what it touched it for
            del self._carriages[pair]
            return
        hand, box, other = carrying
        if carriage.look(self._contacts.place(box), self._place_of(other), now_ns, touches=touches):
            called = {"what": self._text(box), "hand": self._text(hand.thing), "other": self._text(other)}
            text = Reason.of("workcell.carried_touches", **called)
            self._note(text, (hand.thing.name,), carriage.began_ns, carriage)
        if carriage.is_over:
            del self._carriages[pair]

    def _place_of(self, other: Thing) -> Array | None:
        return self._contacts.place(other) if other.kind == "box" else None

    # Hands

    def _look_at_hands(self, now_ns: int) -> None:
        for hand in self._hands:
            if hand.is_found_empty():
                self._note(Reason.of("workcell.is_empty", who=self._text(hand.thing)), (hand.thing.name,), now_ns)
            for box in hand.dropped():
                text = Reason.of("workcell.drops", who=self._text(hand.thing), what=self._text(box))
                self._note(text, (hand.thing.name,), now_ns)
            for box in hand.lost:
                text = Reason.of("workcell.loses", who=self._text(hand.thing), what=self._text(box))
                self._note(text, (hand.thing.name,), now_ns)

    # Telling

    def _text(self, thing: Thing) -> Reason:
        return thing.text(is_alone=self._is_alone)

    def _poses(self) -> bytes:
        return self._plant.poses().tobytes()

    def _note(self, text: Reason, sides: Sequence[str], at_ns: int, carriage: Carriage | None = None) -> None:
        if self._told >= MOST:
            return
        self._told += 1
        devices = tuple(device for side in sides for device in self._devices_of(side))
        poses, lit = (self._poses(), self._lit()) if carriage is None else (carriage.poses, carriage.lit)
        self._mishaps.append(MishapEvent(text, at_ns, devices, poses, lit))
