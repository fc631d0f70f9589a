"""A child: work that is done in a fork of this process, and cannot harm it."""

import os
import pickle
import resource
import select
import signal
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any


def passes(work: Callable[[], bool], wall_s: float, cpu_s: int) -> bool:
    """Whether the work says so; an exception, a crash or more time than this is no."""
    return answer(work, wall_s, cpu_s) is True


def answer(work: Callable[[], Any], wall_s: float, cpu_s: int) -> Any:
    """What the work returns; None where it returns nothing within this time of the clock, and of the processor."""
    return Child.begun(work, cpu_s).answer(wall_s)


def answers(works: Iterable[Callable[[], Any]], at_once: int, wall_s: float, cpu_s: int) -> Iterator[Any]:
    """What each work returns, as they end; so many are done at once."""
    children: dict[int, Child] = {}
    for work in works:
        if len(children) == at_once:
            yield _next(children, wall_s)
        child = Child.begun(work, cpu_s)
        children[child.reading] = child
    while children:
        yield _next(children, wall_s)


@dataclass(frozen=True, slots=True)
class Child:
    """A process, and the end of the pipe from which its answer can be read."""

    pid: int
    reading: int

    @classmethod
    def begun(cls, work: Callable[[], Any], cpu_s: int) -> "Child":
        """Begin with the work, which may take so much of the processor's time."""
        reading, writing = os.pipe()
        pid = os.fork()
        if pid == 0:
            os.close(reading)
            _work(work, writing, cpu_s)
        os.close(writing)
        return cls(pid, reading)

    def answer(self, wall_s: float) -> Any:
        """What it has said within this time, else None; it is no more."""
        try:
            return _read(self.reading, wall_s)
        finally:
            os.close(self.reading)
            with suppress(ProcessLookupError):
                os.killpg(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)


def _next(children: dict[int, Child], wall_s: float) -> Any:
    readable = select.select(list(children), [], [], wall_s)[0] or list(children)
    return children.pop(readable[0]).answer(wall_s)


def _work(work: Callable[[], Any], writing: int, cpu_s: int) -> None:
    """In the child; never returns."""
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CPU, (cpu_s, cpu_s))
        nowhere = os.open(os.devnull, os.O_RDWR)
        for descriptor in range(3):
            os.dup2(nowhere, descriptor)
        said = pickle.dumps(work())
        while said:
            said = said[os.write(writing, said) :]
    finally:
        os._exit(0)


def _read(reading: int, wall_s: float) -> Any:
    parts = []
    while select.select([reading], [], [], wall_s)[0]:
        part = os.read(reading, 1 << 20)
        if not part:
            return pickle.loads(b"".join(parts)) if parts else None
        parts.append(part)
    return None
