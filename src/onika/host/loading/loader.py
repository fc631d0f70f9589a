"""The loader as a process: executes module code to learn of it, so that nothing it does harms the runtime (law 21)."""

import argparse
import select
import signal
import socket
import subprocess
import sys
from time import monotonic_ns
from typing import Any

from msgspec import msgpack

from onika.host.loading.loader_messages import (
    Answer,
    AskCompany,
    AskConstants,
    AskDevices,
    AskFit,
    AskPoses,
    AskPostures,
    AskReach,
    AskSheet,
    Constants,
    Devices,
    Lines,
    Objections,
    Poses,
    Postures,
    Question,
    Reach,
    Sheet,
    Wrong,
)
from onika.host.loading.module_facts import DirectLoading
from onika.host.units.child_process import start
from onika.host.units.output_pipe import open_outlets
from onika.host.units.process_socket import Post
from onika.host.units.rtpu import preload
from onika.link.launcher import die_with_parent
from onika.wire.plan import Code
from onika.wire.request import FaultText
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

PATIENCE_S = 10.0
"""How long a module may take to be imported and looked at."""

encode = msgpack.Encoder().encode
decode_question = msgpack.Decoder(Question).decode
decode_answer = msgpack.Decoder(Answer).decode


class Loader:
    """The runtime's end: asks its loader process, which is started at once and again whenever it had to be ended."""

    def __init__(self) -> None:
        self._post, self._process = self._start()
        self._devices: dict[str, tuple[str, ...] | Fault] = {}

    def sheet(self, code: Code) -> ModuleSheet | Fault:
        """The sheet of a module's class."""
        answer = self._ask(AskSheet(code), code)
        return answer.sheet if isinstance(answer, Sheet) else fault_of(answer)

    def constants(self, code: Code, local: Lines) -> dict[str, Any] | Fault:
        """A robot module's constants from its LOCAL lines."""
        answer = self._ask(AskConstants(code, local), code)
        return answer.values if isinstance(answer, Constants) else fault_of(answer)

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """The devices of a world."""
        if world not in self._devices:
            answer = self._ask(AskDevices(world), Code("", world, world, ""))
            self._devices[world] = answer.names if isinstance(answer, Devices) else fault_of(answer)
        return self._devices[world]

    def resolve(
        self, code: Code, constants: dict[str, Any], targets: list[tuple[str, list[Any]]]
    ) -> list[str | None] | Fault:
        """Why each target is out of reach, or None."""
        answer = self._ask(AskReach(code, constants, targets), code)
        return answer.reasons if isinstance(answer, Reach) else fault_of(answer)

    def poses(
        self, code: Code, constants: dict[str, Any], targets: list[list[Any]]
    ) -> list[list[float]] | Fault | None:
        """The Cartesian targets that joint targets are for a robot module; None: it knows of no poses."""
        answer = self._ask(AskPoses(code, constants, targets), code)
        return answer.nines if isinstance(answer, Poses) else fault_of(answer)

    def postures(
        self, code: Code, constants: dict[str, Any], nines: list[list[float]]
    ) -> list[list[float] | str] | Fault | None:
        """Joint values for Cartesian targets, each nearest to those before it, or why there are none."""
        answer = self._ask(AskPostures(code, constants, nines), code)
        return answer.found if isinstance(answer, Postures) else fault_of(answer)

    def fits(self, code: Code, constants: dict[str, Any], device: str) -> str | Fault:
        """Why a device is not the one that a hardware module means; empty: nothing is wrong."""
        answer = self._ask(AskFit(code, constants, device), code)
        return "; ".join(answer.reasons) if isinstance(answer, Objections) else fault_of(answer)

    def company(self, world: str, devices: tuple[str, ...], *, is_of_flow: bool = False) -> tuple[str, ...] | Fault:
        """Why these devices of a world cannot be used together, or are odd in one flow; none: nothing is said."""
        answer = self._ask(AskCompany(world, devices, is_of_flow), Code("", world, world, ""))
        return answer.reasons if isinstance(answer, Objections) else fault_of(answer)

    def close(self) -> None:
        """End the process."""
        self._post.close()
        self._process.kill()
        self._process.wait()

    def _start(self) -> tuple[Post, "subprocess.Popen[bytes]"]:
        ours, theirs = Post.pair()
        return ours, start("onika.host.loading.loader", theirs)

    @property
    def post(self) -> Post:
        """To wait for in `select`."""
        return self._post

    @property
    def is_lost(self) -> bool:
        """Whether the process has died of a question."""
        return self._post.is_closed

    def send(self, question: Question) -> None:
        """Ask; the answer comes in its time."""
        self._post.send(encode(question))

    def take(self) -> Answer | None:
        """The answer, if it is there."""
        self._post.flush()
        received = self._post.receive()
        return None if received is None else decode_answer(received[0])

    def give_up(self, code: Code) -> Wrong:
        """The process died of a question or does not answer it: start another, and say what happened."""
        silent = Reason.of("host.loader_silent", seconds=PATIENCE_S)
        reason = Reason.of("host.loader_died") if self.is_lost else silent
        self.close()
        self._post, self._process = self._start()
        instead = Reason.of("host.module_not_used", module=code.module)
        return Wrong(FaultText(code.path, 0, reason, instead))

    def _ask(self, question: Question, code: Code) -> Answer:
        self.send(question)
        until = monotonic_ns() + round(PATIENCE_S * 1e9)
        while (left := until - monotonic_ns()) > 0 and not self.is_lost:
            select.select([self._post], [self._post] if self._post.is_waiting else [], [], left * 1e-9)
            answer = self.take()
            if answer is not None:
                return answer
        return self.give_up(code)


def fault_of(answer: Answer) -> Fault:
    """What is wrong with a module, as a fault."""
    if not isinstance(answer, Wrong):
        raise TypeError(f"expected the answer to the question, found {answer!r}")
    text = answer.fault
    return Fault(
        Place(text.file, text.line),
        text.reason,
        text.instead,
    )


def _answer(question: Question, loading: DirectLoading) -> Answer:
    found: Any
    match question:
        case AskSheet():
            found = loading.sheet(question.code)
            return _wrong(found) if isinstance(found, Fault) else Sheet(found, loading.cost_ns(question.code))
        case AskConstants():
            found = loading.constants(question.code, question.local)
            return _wrong(found) if isinstance(found, Fault) else Constants(found)
        case AskDevices():
            found = loading.devices(question.world)
            return _wrong(found) if isinstance(found, Fault) else Devices(found)
        case AskReach():
            found = loading.resolve(question.code, question.constants, question.targets)
            return _wrong(found) if isinstance(found, Fault) else Reach(found)
        case AskPoses():
            found = loading.poses(question.code, question.constants, question.targets)
            return _wrong(found) if isinstance(found, Fault) else Poses(found)
        case AskPostures():
            found = loading.postures(question.code, question.constants, question.nines)
            return _wrong(found) if isinstance(found, Fault) else Postures(found)
        case AskFit():
            found = loading.fits(question.code, question.constants, question.device)
            return _wrong(found) if isinstance(found, Fault) else Objections((found,) if found else ())
        case AskCompany():
            found = loading.company(question.world, question.devices, is_of_flow=question.is_of_flow)
            return _wrong(found) if isinstance(found, Fault) else Objections(found)


def _wrong(fault: Fault) -> Wrong:
    return Wrong(FaultText(fault.place.file, fault.place.line, fault.reason, fault.instead))


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--fd", type=int, required=True)
    parser.add_argument("--parent", type=int, required=True)
    given = parser.parse_args(words)
    die_with_parent(given.parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_outlets()
    preload()
    post, loading = Post(socket.socket(fileno=given.fd)), DirectLoading()
    while not post.is_closed:
        select.select([post], [post] if post.is_waiting else [], [])
        post.flush()
        received = post.receive()
        if received is not None:
            post.send(encode(_answer(decode_question(received[0]), loading)))


if __name__ == "__main__":
    main(sys.argv[1:])
