"""A lookout over a world that is files: it watches for what no program means (requirements E16, X19).

It looks at the contacts again and again. A gripper may touch the part that it takes, and a part that is carried what
it is taken from and put on; a hand of several fingers may touch whatever moves freely. Whatever else an arm, a hand or
what it carries touches is a mishap, and so is an arm that meets itself, a hand that closes on nothing, loses what it
holds or drops it, and a part that falls to the floor.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from onika.laws.frames import Array
from onika.model.world import WorldText
from onika.ring.device import MishapEvent
from onika.words.reason import Reason
from onika.workcell.carriage import APART_M, Carriage
from onika.workcell.cell.cell_contacts import CellContact, CellContacts
from onika.workcell.cell.cell_thing import FLOOR, FREE, HAND, CellThing, contact_of, rank
from onika.workcell.cell.watched_gripper import WatchedGripper
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.gripping.finger_way import FingerWay
from onika.workcell.gripping.forceless import Forceless
from onika.workcell.gripping.tool_frame import ToolFrame
from onika.workcell.plant import Plant

MOST = 50
"""Mishaps that are told of one world; one that has so many needs no more of them."""

_EVERY_NS = 8_000_000  # how often it looks: what touches something is not gone again sooner
_AGAIN_NS = 500_000_000  # how long two things were apart that meet anew

Advance = Callable[[Any, Any], None]
Pair = tuple[CellThing, CellThing]


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


class CellLookout:
    """Watches one world, compiled as often as it is.

    devices_of  the devices at a place that are in use
    lit         the shapes that shine just now
    """

    def __init__(
        self, world: WorldText, devices_of: Callable[[str], tuple[str, ...]], lit: Callable[[], tuple[str, ...]]
    ) -> None:
        self._world = world
        self._devices_of = devices_of
        self._lit = lit
        self._told = 0
        self._mishaps: list[MishapEvent] = []
        self._felt: dict[Pair, int] = {}
        """When two things that touch, or did, were felt last."""
        self._carriages: dict[Pair, Carriage] = {}
        self._carrier: dict[CellThing, str] = {}
        """The place of the hand in which each part was last."""
        self._hands: tuple[WatchedGripper, ...] = ()

    def watch(
        self,
        plant: Plant,
        arms: Mapping[JointUnit, bool],
        hands: Mapping[FingerUnit, tuple[FingerWay, ToolFrame]],
        advance: Advance,
        now: Callable[[], int],
        forceless: Forceless | None,
    ) -> Advance:
        """Look at this plant again and again from now on; gives what makes a step and looks.

        arms        those that stand there, each with whether its robot has a hand
        hands       the grippers that arms bear
        forceless   what moves it, where things do not press on each other but reach into each other
        """
        contacts = CellContacts(plant, self._world, arms)
        self._plant, self._contacts, self._forceless = plant, contacts, forceless
        things = {unit: contacts.hand(unit.side) for unit in hands}
        self._hands = tuple(
            WatchedGripper(unit, *hands[unit], contacts, thing, now())
            for unit, thing in things.items()
            if thing is not None
        )
        self._watched = {hand.thing for hand in self._hands}
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
        held = {part: hand.thing.name for hand in self._hands for part in hand.held}
        if held:
            self._carrier.update(held)
            touching = self._contacts.touching(held, is_deep=self._forceless is not None)
        pairs = {(contact.one, contact.other) for contact in touching if not self._is_meant(contact, now_ns)}
        touched = {contact.other for contact in touching if contact.one.kind == HAND} - set(held)
        self._carry(pairs, now_ns)
        for pair in sorted(pairs, key=_order):
            if self._is_new(pair, now_ns) and not is_first:
                self._judge(pair, touched, now_ns)
        for arm in self._contacts.of_themselves(is_first=is_first):
            if self._is_new((arm, arm), now_ns):
                self._note(Reason.of("workcell.meets_itself", who=arm.text), (arm.name,), now_ns)
        self._look_at_hands(now_ns)

    def _is_new(self, pair: Pair, now_ns: int) -> bool:
        is_new = now_ns - self._felt.get(pair, -_AGAIN_NS) >= _AGAIN_NS
        self._felt[pair] = now_ns
        return is_new

    def _touching(self) -> list[CellContact]:
        if self._forceless is None:
            return self._contacts.touching()
        self._contacts.collide()
        return self._contacts.touching(is_deep=True)

    def _squeezed(self, hand: WatchedGripper, touching: list[CellContact]) -> list[CellThing]:
        if self._forceless is None:
            return hand.squeezed(touching)
        return [self._contacts.part(name) for name in self._forceless.carried(hand.unit)]

    def _is_meant(self, contact: CellContact, now_ns: int) -> bool:
        """Whether a hand touches a part as one that takes it does."""
        if contact.other.kind != FREE or contact.one.kind != HAND:
            return False
        if contact.one not in self._watched:
            return True
        return any(hand.thing == contact.one and hand.means(contact, now_ns) for hand in self._hands)

    def _judge(self, pair: Pair, touched: set[CellThing], now_ns: int) -> None:
        """Two things meet that were apart: whether that is told at once."""
        one, other = pair
        if one.moves:
            self._tell(pair, now_ns)
        elif (
            other.kind == FLOOR and one not in touched and pair not in self._carriages and self._carrying(pair) is None
        ):
            places = (self._carrier[one],) if one in self._carrier else ()
            self._note(Reason.of("workcell.falls", what=one.text), places, now_ns)

    def _tell(self, pair: Pair, now_ns: int) -> None:
        places = tuple(dict.fromkeys(thing.name for thing in pair if thing.moves))
        self._note(contact_of(*pair), places, now_ns)

    # What is carried

    def _carrying(self, pair: Pair) -> tuple[WatchedGripper, CellThing, CellThing] | None:
        """The hand that has one of two things that are in no hand both, that one, and the other."""
        for part, other in (pair, pair[::-1]):
            for hand in self._hands:
                if part in hand.held and other not in hand.held:
                    return hand, part, other
        return None

    def _carry(self, pairs: Iterable[Pair], now_ns: int) -> None:
        for pair in pairs:
            carrying = self._carrying(pair)
            if carrying is not None and not carrying[2].moves and pair not in self._carriages:
                self._carriages[pair] = self._begun(*carrying, now_ns)
        for pair, carriage in list(self._carriages.items()):
            self._follow(pair, carriage, now_ns, touches=pair in pairs)

    def _begun(self, hand: WatchedGripper, part: CellThing, other: CellThing, now_ns: int) -> Carriage:
        place = self._contacts.place(part)
        is_lifted = float(np.linalg.norm(place - hand.held[part])) < APART_M
        return Carriage(now_ns, self._poses(), self._lit(), place, self._place_of(other), is_lifted, now_ns)

    def _follow(self, pair: Pair, carriage: Carriage, now_ns: int, *, touches: bool) -> None:
        carrying = self._carrying(pair)
        if carrying is None:  # it was let go: that is what it touched it for
            del self._carriages[pair]
            return
        hand, part, other = carrying
        if carriage.look(self._contacts.place(part), self._place_of(other), now_ns, touches=touches):
            text = Reason.of("workcell.carried_touches", what=part.text, hand=hand.thing.text, other=other.text)
            self._note(text, (hand.thing.name,), carriage.began_ns, carriage)
        if carriage.is_over:
            del self._carriages[pair]

    def _place_of(self, other: CellThing) -> Array | None:
        return self._contacts.place(other) if other.kind == FREE else None

    # Hands

    def _look_at_hands(self, now_ns: int) -> None:
        for hand in self._hands:
            who, places = hand.thing.text, (hand.thing.name,)
            if hand.is_found_empty():
                self._note(Reason.of("workcell.is_empty", who=who), places, now_ns)
            for part in hand.dropped():
                self._note(Reason.of("workcell.drops", who=who, what=part.text), places, now_ns)
            for part in hand.lost:
                self._note(Reason.of("workcell.loses", who=who, what=part.text), places, now_ns)

    # Telling

    def _poses(self) -> bytes:
        return self._plant.poses().tobytes()

    def _note(self, text: Reason, places: Sequence[str], at_ns: int, carriage: Carriage | None = None) -> None:
        if self._told >= MOST:
            return
        self._told += 1
        devices = tuple(device for place in places for device in self._devices_of(place))
        poses, lit = (self._poses(), self._lit()) if carriage is None else (carriage.poses, carriage.lit)
        self._mishaps.append(MishapEvent(text, at_ns, devices, poses, lit))


def _order(pair: Pair) -> tuple[tuple[int, CellThing], tuple[int, CellThing]]:
    return rank(pair[0]), rank(pair[1])
