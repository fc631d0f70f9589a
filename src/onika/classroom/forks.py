"""Processes of a class: forked from a server that has loaded the environment once, for seats and for grading (X25)."""

import asyncio
import os
import socket
import threading
from collections.abc import Callable
from dataclasses import replace
from multiprocessing import context as contexts, forkserver, get_context
from pathlib import Path
from time import monotonic
from typing import Any

import msgspec

from onika.classroom.attended_seat import Begins, SeatProcess
from onika.classroom.grading import LIMIT_S, Grading, grade_apart
from onika.classroom.roster import Grade, Learner
from onika.classroom.seat_program import SeatSettings, keep_seat
from onika.web.server import bound
from onika.words.reason import Reason

_LOADED = ("onika.classroom.seat_program", "onika.classroom.grading")
_LARGEST_GRADE = 1 << 20


class Forks:
    """Forks the processes of one class.

    settings   of every seat; number, learner and folder are its own
    port       of the first seat, those behind it for the others; 0: any that are free
    """

    def __init__(self, settings: SeatSettings, host: str, port: int) -> None:
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # a process that is forked may have one thread only
        self._context: contexts.ForkServerContext = get_context("forkserver")
        self._context.set_forkserver_preload(list(_LOADED))
        self._lock = threading.Lock()
        self._settings = settings
        self._host = host
        self._port = port

    def warm(self) -> None:
        """Begin to load what every process needs, before the first one is wanted."""
        with self._lock:
            forkserver.ensure_running()

    def seat(self, learner: Learner) -> Begins:
        """How the seat of a learner begins."""
        folder = self._settings.folder / f"{learner.seat:02}"
        settings = replace(self._settings, number=learner.seat, learner=learner.name, folder=folder)

        def begins() -> tuple[SeatProcess, socket.socket, int]:
            with bound(self._port + learner.seat - 1 if self._port else 0, self._host) as listening:
                ours, theirs = socket.socketpair()
                with theirs:
                    process = self._begun(keep_seat, settings, listening, theirs)
                ours.setblocking(False)
                return process, ours, listening.getsockname()[1]

        return begins

    def grader(self, grading: Grading, scratch: Path) -> "ForkedGrader":
        """Who grades hand-ins."""
        return ForkedGrader(grading, scratch, self._begun)

    def _begun(self, target: Callable[..., None], *arguments: Any) -> SeatProcess:
        """Start a process; raises OSError."""
        with self._lock:
            process = self._context.Process(target=target, args=arguments, daemon=True)
            process.start()
        return process


class ForkedGrader:
    """Grades hand-ins, each in a process of its own."""

    def __init__(self, grading: Grading, scratch: Path, begins: Callable[..., SeatProcess]) -> None:
        self._grading = grading
        self._scratch = scratch
        self._begins = begins

    async def grade(self, number: int, folder: Path) -> Grade | None:
        """The grade of the hand-in in a folder; None: nothing is expected."""
        if not self._grading.is_wanted:
            return None
        return await asyncio.to_thread(self._grade, number, folder)

    def _grade(self, number: int, folder: Path) -> Grade:
        ours, theirs = socket.socketpair()
        with ours:
            with theirs:
                process = self._begins(grade_apart, self._grading, number, folder, self._scratch, theirs)
            try:
                return msgspec.json.decode(_answer(ours), type=Grade)
            except TimeoutError:
                return Grade(number, why=Reason.of("class.grading_long", seconds=LIMIT_S))
            except (OSError, ValueError):
                return Grade(number, why=Reason.of("class.grading_broken"))
            finally:
                process.kill()
                process.join(5.0)


def _answer(ours: socket.socket) -> bytes:
    """All that comes; raises TimeoutError where it takes too long."""
    until_s, answer = monotonic() + LIMIT_S, b""
    while len(answer) <= _LARGEST_GRADE:
        ours.settimeout(max(0.01, until_s - monotonic()))
        piece = ours.recv(1 << 16)
        if not piece:
            return answer
        answer += piece
    raise ValueError(len(answer))
