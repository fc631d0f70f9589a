"""The loader client asks the loader process and never waits: whoever wanted what is not known yet tries again.

A change is checked by plain functions that ask `Loading`. Here an unknown answer raises NotYet; the program keeps the
request and carries it out anew when the answer is there, so that a slow module never stands between two jobs.
"""

from collections import OrderedDict, deque
from collections.abc import Collection, Iterable
from time import monotonic_ns
from typing import Any

from onika.host.loading.loader import PATIENCE_S, Loader, encode, fault_of
from onika.host.loading.loader_messages import (
    Answer,
    AskCompany,
    AskConstants,
    AskDevices,
    AskFit,
    AskKind,
    AskPoses,
    AskPostures,
    AskReach,
    AskSheet,
    AskWorldFaults,
    Constants,
    Devices,
    Kind,
    KnownPoses,
    Lines,
    Objections,
    Postures,
    Question,
    Reach,
    Sheet,
    WorldFaults,
)
from onika.host.processes.process_socket import ProcessSocket
from onika.host.units.world_sources import WorldSources
from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.wire.world_source import WorldSource
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import NOTHING, Reason

_KEPT = 2000
"""Answers that are remembered; a module's answer changes only with its source, which is part of the question."""


class NotYet(Exception):
    """The answer is being looked for; try again when `take` has said True."""


class LoaderClient:
    """Answers from memory, or NotYet. One question is under way at a time; they are asked in turn.

    worlds      the only worlds that there are here; none named: all
    """

    def __init__(self, loader: Loader, worlds: Collection[str] = ()) -> None:
        self._loader = loader
        self._worlds = tuple(worlds)
        self._answers: OrderedDict[bytes, Answer] = OrderedDict()
        self._open: deque[tuple[bytes, Question, Code]] = deque()
        self._since_ns = 0
        self._sources = WorldSources()
        self._is_outdated = False
        """Whether the question under way was asked before something else was offered."""

    @property
    def post(self) -> ProcessSocket:
        """To wait for in `select`."""
        return self._loader.post

    def sheet(self, code: Code) -> ModuleSheet | Fault:
        """The sheet of a module's class."""
        answer = self._ask(AskSheet(code), code)
        if isinstance(answer, Sheet):
            return answer.sheet
        return fault_of(answer)

    def cost_ns(self, code: Code) -> int:
        """What loading this module takes in a unit that has its libraries; 0 where nothing is known of it."""
        answer = self._answers.get(encode(AskSheet(code)))
        return answer.cost_ns if isinstance(answer, Sheet) else 0

    def constants(self, code: Code, local: Lines) -> dict[str, Any] | Fault:
        """A robot module's constants from its LOCAL lines and its device."""
        answer = self._ask(AskConstants(code, local), code)
        if isinstance(answer, Constants):
            return answer.values
        return fault_of(answer)

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """The devices of a world."""
        if (other := self._other_world(world)) is not None:
            return other
        answer = self._ask(AskDevices(world), Code("", world, world, ""))
        if isinstance(answer, Devices):
            return answer.names
        return fault_of(answer)

    def is_simulated(self, world: str) -> bool | Fault:
        """Whether a world is simulated."""
        if (other := self._other_world(world)) is not None:
            return other
        answer = self._ask(AskKind(world), Code("", world, world, ""))
        if isinstance(answer, Kind):
            return answer.is_simulated
        return fault_of(answer)

    def resolve(
        self, code: Code, constants: dict[str, Any], targets: list[tuple[str, list[Any]]]
    ) -> list[Reason | None] | Fault:
        """Why each target is out of reach, or None."""
        answer = self._ask(AskReach(code, constants, targets), code)
        if isinstance(answer, Reach):
            return answer.reasons
        return fault_of(answer)

    def poses(
        self, code: Code, constants: dict[str, Any], targets: list[list[Any]]
    ) -> list[list[float]] | Fault | None:
        """The Cartesian targets that joint targets are for a robot module; None: it knows of no poses."""
        answer = self._ask(AskPoses(code, constants, targets), code)
        if isinstance(answer, KnownPoses):
            return answer.poses
        return fault_of(answer)

    def postures(
        self, code: Code, constants: dict[str, Any], poses: list[list[float]]
    ) -> list[list[float] | Reason] | Fault | None:
        """Joint values for Cartesian targets, each nearest to those before it, or why there are none."""
        answer = self._ask(AskPostures(code, constants, poses), code)
        if isinstance(answer, Postures):
            return answer.found
        return fault_of(answer)

    def fits(self, code: Code, constants: dict[str, Any], device: str) -> Reason | Fault:
        """Why a device is not the one that a hardware module means; NOTHING: nothing is wrong."""
        answer = self._ask(AskFit(code, constants, device), code)
        if isinstance(answer, Objections):
            return next(iter(answer.reasons), NOTHING)
        return fault_of(answer)

    def company(self, world: str, devices: tuple[str, ...], *, is_of_flow: bool = False) -> tuple[Reason, ...] | Fault:
        """Why these devices of a world cannot be used together, or are odd in one flow; none: nothing is said."""
        answer = self._ask(AskCompany(world, devices, is_of_flow), Code("", world, world, ""))
        if isinstance(answer, Objections):
            return answer.reasons
        return fault_of(answer)

    def offer(self, worlds: Iterable[WorldSource]) -> None:
        """These worlds are files; what was said of others of their names is forgotten."""
        new = self._sources.take(worlds)
        for files in new:
            self._loader.offer(files)
        if new:
            self._answers.clear()
            self._is_outdated = bool(self._open)

    def world_faults(self, world: str) -> tuple[Fault, ...]:
        """All that is wrong with the files of a world; nothing where it is made of none."""
        if self._sources.find(world) is None:
            return ()
        answer = self._ask(AskWorldFaults(world), Code("", world, world, ""))
        if not isinstance(answer, WorldFaults):
            return (fault_of(answer),)
        return tuple(text.fault for text in answer.faults)

    def expect(self, codes: tuple[Code, ...]) -> None:
        """These modules will be asked about: begin with all of them."""
        for code in codes:
            self._request(AskSheet(code), code)

    def take(self) -> bool:
        """Whether an answer has come since the last call, or the loader was given up for one; never waits."""
        if not self._open:
            return False
        answer = self._loader.take()
        key, _, code = self._open[0]
        if answer is None and (self._loader.is_lost or monotonic_ns() - self._since_ns > PATIENCE_S * 1e9):
            answer = self._loader.give_up(code)
        if answer is None:
            return False
        if self._is_outdated:
            self._is_outdated = False
            self._begin()
            return False
        self._answers[key] = answer
        while len(self._answers) > _KEPT:
            self._answers.popitem(last=False)
        self._open.popleft()
        self._begin()
        return True

    def _other_world(self, world: str) -> Fault | None:
        """Why a world is none of those that there are here."""
        if not self._worlds or world.partition("@")[0] in self._worlds:
            return None
        return Fault(Place(world), Reason.of("host.world_not_here", world=world, worlds=self._worlds), NOT_RUN)

    def _ask(self, question: Question, code: Code) -> Answer:
        key = self._request(question, code)
        if key not in self._answers:
            raise NotYet
        self._answers.move_to_end(key)
        return self._answers[key]

    def _request(self, question: Question, code: Code) -> bytes:
        key = encode(question)
        if key not in self._answers and key not in (waiting for waiting, _, _ in self._open):
            self._open.append((key, question, code))
            if len(self._open) == 1:
                self._begin()
        return key

    def _begin(self) -> None:
        if self._open:
            self._since_ns = monotonic_ns()
            self._loader.send(self._open[0][1])
