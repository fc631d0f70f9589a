"""The process that renders for the cameras of a world, from the side of that world: asked, and never waited for."""

import os
import select
import socket
from collections.abc import Iterator
from contextlib import suppress

import numpy as np
import numpy.typing as npt

from onika.ring.segment import Segment
from onika.words.reason import Reason
from onika.workcell.filmed.begun_process import BegunProcess
from onika.workcell.filmed.camera_messages import Exposed, Exposure, Film, decode_exposed, encode, room_of

WAYS = ("egl", "osmesa")
"""Ways to draw without a screen, the better one first."""

_LARGEST = 1 << 20
_PROCESS = "onika.workcell.filmed.camera_process"
_REAL_PROCESS = "onika.workcell.filmed.real_camera_process"
_ENDED = "the process that renders has ended"


class CameraRenderer:
    """Renders what is asked for, in a process that begins with this; where one way to draw fails the next is tried.

    A real camera has a process, too, which reads its pictures, and nothing that could be tried instead. Raises
    SharedMemoryRefused.
    """

    def __init__(self, film: Film, ways: tuple[str, ...] = WAYS) -> None:
        self._content, self._film = film, Segment.create("film", 1)  # written by the process that is to have it
        self._memory = Segment.create("pictures", room_of(film.eyes))
        self.pixels: tuple[npt.NDArray[np.uint8], ...] = tuple(
            np.frombuffer(self._memory.view, np.uint8, 3 * eye.width * eye.height, eye.offset).reshape(
                eye.height, eye.width, 3
            )
            for eye in film.eyes
        )
        self._source = film.source
        self._ways = [""] if film.source else [*ways]
        self._owed: dict[int, Exposure] = {}
        self._why = Reason.of("workcell.camera_ended") if film.source else Reason.plain(_ENDED)
        self._process: BegunProcess | None = None
        self._start()

    @property
    def owed(self) -> frozenset[int]:
        """The cameras whose pictures are still to come."""
        return frozenset(self._owed)

    def ask(self, exposure: Exposure) -> None:
        """Want one more picture; one of a camera at a time."""
        self._owed[exposure.eye] = exposure
        self._send(exposure)

    def answers(self, patience_s: float = 0.0) -> Iterator[Exposed]:
        """What has come, waiting so long for the first of it; where nothing draws, why, for all that is owed."""
        while self._owed:
            if self._process is None:
                why = self._why if self._source else Reason.of("workcell.no_graphics", why=self._why)
                owed, self._owed = self._owed, {}
                yield from (Exposed(exposure.eye, exposure.taken_ns, why=why) for exposure in owed.values())
                return
            if not select.select([self._post], [], [], patience_s)[0]:
                return
            answer = self._receive()
            if answer is not None and answer.why is None:
                self._owed.pop(answer.eye, None)
                patience_s = 0.0
                yield answer
            else:
                self._why = self._why if answer is None or answer.why is None else answer.why
                self._end()
                self._start()

    def close(self) -> None:
        """End the process."""
        self._ways.clear()
        self._owed.clear()
        self._end()

    def _start(self) -> None:
        """Begin anew in the next way; what is owed is asked for again."""
        if not self._ways:
            return
        self._post, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        for end in (self._post, theirs):
            end.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, _LARGEST)
        fds = theirs.fileno(), self._film.fd, self._memory.fd
        words = ("--fd", "--film", "--pixels")
        options = [part for word, fd in zip(words, fds, strict=True) for part in (word, str(fd))]
        without = {name: value for name, value in os.environ.items() if name != "PYOPENGL_PLATFORM"}
        environment = {**without, "MUJOCO_GL": self._ways.pop(0), "LP_NUM_THREADS": "1"}
        module = _REAL_PROCESS if self._source else _PROCESS
        with suppress(OSError):  # no room for a process: then there are no pictures
            self._process = BegunProcess(module, options, fds, environment, self._write)
        theirs.close()
        for exposure in self._owed.values():
            self._send(exposure)

    def _write(self) -> None:
        """The files of a world may be as large as its meshes: to write them is no matter of the loop that steps it."""
        content = memoryview(encode(self._content))
        os.ftruncate(self._film.fd, len(content))
        at = 0
        while at < len(content):
            at += os.pwrite(self._film.fd, content[at:], at)

    def _send(self, exposure: Exposure) -> None:
        try:
            if self._process is not None:
                self._post.send(encode(exposure), socket.MSG_DONTWAIT)
        except OSError:
            pass  # it is gone: who waits for its answers sees that

    def _receive(self) -> Exposed | None:
        try:
            word = self._post.recv(_LARGEST, socket.MSG_DONTWAIT)
        except OSError:
            return None
        return decode_exposed(word) if word else None

    def _end(self) -> None:
        if self._process is not None:
            self._post.close()
            self._process.end()
            self._process = None
