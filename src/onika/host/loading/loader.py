"""The loader as a process: executes module code to learn of it, so that nothing it does harms the runtime (law 21)."""

import argparse
import select
import signal
import socket
import sys
from collections.abc import Callable
from typing import Any

from msgspec import msgpack

from onika.host.guards.memory_limit import bound
from onika.host.guards.outside_guard import stay_inside
from onika.host.loading.load_alarm import LoadAlarm
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
    Objections,
    Postures,
    Question,
    Reach,
    Sheet,
    TakeWorld,
    UnusableModule,
    WorldFaults,
)
from onika.host.loading.loader_start import LoaderStart, start_loader
from onika.host.loading.module_facts import ModuleFacts
from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.preloaded_libraries import preload
from onika.host.processes.process_socket import ProcessSocket
from onika.host.sandbox.sandbox_process import refusal
from onika.host.units.world_sources import packed, unpacked
from onika.link.child.launcher import die_with_parent
from onika.ring.segment import Segment
from onika.wire.plan import Code
from onika.wire.request import FaultText
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

PATIENCE_S = 10.0
"""How long a module may take to be imported and looked at."""

LONGEST = 1 << 17
"""Bytes of an answer: a module with a thousand ports needs less, and every system can send as much in one piece."""

_ABOUT_WORLDS = (AskDevices, AskCompany, AskKind, AskWorldFaults)

encode = msgpack.Encoder().encode
decode_question = msgpack.Decoder(Question | TakeWorld).decode
decode_answer = msgpack.Decoder(Answer).decode


class Loader:
    """The runtime's end of the loader process, which is started at once and again whenever it had to be ended.

    `loader_start` is one that was started before. What is asked about modules of others, which may do nothing but
    compute, is asked of a second process, which is confined and is started with the first such question.
    """

    def __init__(self, loader_start: LoaderStart | None = None, *, stays_inside: bool = False) -> None:
        self._stays_inside = stays_inside
        self._worlds: dict[str, Segment] = {}
        self._processes = {False: loader_start or self._started(is_confined=False)}
        self._is_confined = False
        """Whether the question under way is for the confined one."""

    @property
    def _current(self) -> LoaderStart:
        return self._processes[self._is_confined]

    def close(self) -> None:
        """End the processes."""
        for process in self._processes.values():
            process.end()

    def _started(self, *, is_confined: bool) -> LoaderStart:
        """A new process, which knows the worlds."""
        process = start_loader(stays_inside=self._stays_inside, is_confined=is_confined)
        for world in self._worlds:
            self._tell(process, world)
        return process

    def _tell(self, process: LoaderStart, world: str) -> None:
        process.post.send(encode(TakeWorld(world)), (self._worlds[world].fd,))

    @property
    def post(self) -> ProcessSocket:
        """To wait for in `select`."""
        return self._current.post

    @property
    def is_lost(self) -> bool:
        """Whether the process has died of a question."""
        return self._current.post.is_closed

    def offer(self, files: WorldSource) -> None:
        """From now on this world is made of these files."""
        self._worlds[files.world] = packed(files)
        for process in self._processes.values():
            self._tell(process, files.world)

    def send(self, question: Question) -> None:
        """Ask; the answer comes in its time."""
        self._is_confined = not isinstance(question, _ABOUT_WORLDS) and question.code.is_sandboxed
        if self._is_confined not in self._processes:
            self._processes[True] = self._started(is_confined=True)
        self._current.post.send(encode(question))

    def take(self) -> Answer | None:
        """The answer, if it is there."""
        self._current.post.flush()
        received = self._current.post.receive()
        return None if received is None else decode_answer(received[0])

    def give_up(self, code: Code) -> UnusableModule:
        """The process died of a question or does not answer it: start another, and say what happened."""
        silent = Reason.of("host.loader_silent", seconds=PATIENCE_S)
        reason = Reason.of("host.loader_died") if self.is_lost else silent
        self._current.end()
        self._processes[self._is_confined] = self._started(is_confined=self._is_confined)
        instead = Reason.of("host.module_not_used", module=code.module)
        return UnusableModule(FaultText(code.path, 0, reason, instead))


def fault_of(answer: Answer) -> Fault:
    """What is wrong with a module, as a fault."""
    if not isinstance(answer, UnusableModule):
        raise TypeError(f"expected the answer to the question, found {answer!r}")
    return answer.fault.fault


def _answer(question: Question, facts: ModuleFacts) -> Answer:
    fact, message = _fact(question, facts)
    return _wrong(fact) if isinstance(fact, Fault) else message(fact)


def _fact(question: Question, facts: ModuleFacts) -> tuple[Any, Callable[[Any], Answer]]:
    """What is asked, or a fault; and the message that it becomes where it is none."""
    match question:
        case AskSheet():
            return facts.sheet(question.code), lambda sheet: Sheet(sheet, facts.cost_ns(question.code))
        case AskConstants():
            return facts.constants(question.code, question.local), Constants
        case AskWorldFaults():
            return facts.world_faults(question.world), _world_faults
        case AskDevices():
            return facts.devices(question.world), Devices
        case AskKind():
            return facts.is_simulated(question.world), Kind
        case AskReach():
            return facts.resolve(question.code, question.constants, question.targets), Reach
        case AskPoses():
            return facts.poses(question.code, question.constants, question.targets), KnownPoses
        case AskPostures():
            return facts.postures(question.code, question.constants, question.poses), Postures
        case AskFit():
            objection = facts.fits(question.code, question.constants, question.device)
            return objection, lambda reason: Objections((reason,) if reason else ())
        case AskCompany():
            return facts.company(question.world, question.devices, is_of_flow=question.is_of_flow), Objections


def _packed(question: Question, facts: ModuleFacts) -> bytes:
    """The answer as bytes; one that is too long to be told is a fault of the module."""
    body = encode(_answer(question, facts))
    if len(body) <= LONGEST:
        return body
    return encode(_refused(question, Reason.of("host.answer_too_long", size=len(body), most=LONGEST)))


def _asked_about(question: Question) -> tuple[str, str]:
    """The file that a question is about, and its name."""
    if isinstance(question, _ABOUT_WORLDS):
        return question.world, question.world
    return question.code.path, question.code.module


def _refused(question: Question, reason: Reason) -> UnusableModule:
    place, module = _asked_about(question)
    return _wrong(Fault(Place(place), reason, Reason.of("host.module_not_used", module=module)))


def _world_faults(faults: tuple[Fault, ...]) -> WorldFaults:
    return WorldFaults(tuple(map(FaultText.of, faults)))


def _wrong(fault: Fault) -> UnusableModule:
    return UnusableModule(FaultText.of(fault))


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--fd", type=int, required=True)
    parser.add_argument("--parent", type=int, required=True)
    parser.add_argument("--stays-inside", action="store_true")
    parser.add_argument("--confined", action="store_true")
    given = parser.parse_args(words)
    die_with_parent(given.parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_output_pipes()
    preload()
    bound()
    if given.stays_inside:
        stay_inside()
    post, loading = ProcessSocket(socket.socket(fileno=given.fd)), ModuleFacts(LoadAlarm().watch)
    refused = refusal() if given.confined else NOTHING
    while not post.is_closed:
        select.select([post], [post] if post.is_waiting else [], [])
        post.flush()
        received = post.receive()
        if received is not None:
            question = decode_question(received[0])
            if isinstance(question, TakeWorld):
                loading.offer([unpacked(received[1][0])])
            elif refused:
                post.send(encode(_refused(question, refused)))
            else:
                post.send(_packed(question, loading))


if __name__ == "__main__":
    main(sys.argv[1:])
