"""Reads a real camera: `python -m onika.workcell.filmed.real_camera_process --fd N --film N --pixels N`.

A process of its own for each of them, so that a camera that hangs hangs nobody else (decision 50). OpenCV opens it: by
V4L2 where it is a number or a path of a device; a film, or a row of pictures as `frame_%02d.png`, is as good.
"""

import argparse
import importlib
import os
import signal
import socket
import sys
from contextlib import suppress
from typing import Any

import numpy as np
import numpy.typing as npt

from onika.ring.segment import Segment
from onika.words.reason import Reason
from onika.workcell.filmed.camera_messages import Exposed, Eye, Film, decode_exposure, decode_film, encode
from onika.workcell.filmed.small_picture import small_picture

NICE = 10
_LARGEST = 1 << 20  # bytes of an order

Pixels = npt.NDArray[np.uint8]


class CameraRefused(Exception):
    """There is no picture, for this reason."""

    def __init__(self, reason: Reason) -> None:
        super().__init__(reason)
        self.reason = reason


class RealCamera:
    """A camera, opened; raises CameraRefused."""

    def __init__(self, source: str, eye: Eye, opencv: Any) -> None:
        self._source, self._size, self._opencv = source, (eye.width, eye.height), opencv
        number = int(source) if source.isdecimal() else source
        self._capture = opencv.VideoCapture(number)
        if not self._capture.isOpened():
            raise CameraRefused(Reason.of("workcell.camera_not_open", source=source))
        self._capture.set(opencv.CAP_PROP_FRAME_WIDTH, eye.width)
        self._capture.set(opencv.CAP_PROP_FRAME_HEIGHT, eye.height)
        self._capture.set(opencv.CAP_PROP_BUFFERSIZE, 1)  # what waits in a row would be old

    def read(self, pixels: Pixels) -> None:
        """The next picture, red green blue, in the size that is wanted; raises CameraRefused."""
        is_there, picture = self._capture.read()
        if not is_there:
            raise CameraRefused(Reason.of("workcell.camera_gone", source=self._source))
        if picture.shape[:2] != (self._size[1], self._size[0]):
            picture = self._opencv.resize(picture, self._size, interpolation=self._opencv.INTER_AREA)
        np.copyto(pixels, picture[:, :, ::-1])

    def close(self) -> None:
        """Give it back."""
        self._capture.release()


def serve(post: socket.socket, film: Film, memory: memoryview) -> None:
    """Answer each order until nobody gives any more; after a failure only why it failed."""
    (eye,) = film.eyes
    count = 3 * eye.width * eye.height
    pixels = np.frombuffer(memory, np.uint8, count, eye.offset).reshape(eye.height, eye.width, 3)
    camera: RealCamera | None = None
    why: Reason | None = None
    while order := post.recv(_LARGEST):
        exposure = decode_exposure(order)
        if why is None:
            try:
                camera = camera or RealCamera(film.source, eye, _opencv())
                camera.read(pixels)
            except CameraRefused as refused:
                why = refused.reason
            # whatever a driver raises means the same here
            except Exception as fault:
                why = Reason.plain(" ".join(str(fault).split())[:200] or type(fault).__name__)
        small = small_picture(pixels) if exposure.is_shown and why is None else b""
        post.send(encode(Exposed(exposure.eye, exposure.taken_ns, small, why)))
    if camera is not None:
        camera.close()


def _opencv() -> Any:
    try:
        return importlib.import_module("cv2")
    except ImportError:
        raise CameraRefused(Reason.of("workcell.no_opencv")) from None


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    for option in ("--fd", "--film", "--pixels"):
        parser.add_argument(option, type=int, required=True)
    given = parser.parse_args(words)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.nice(NICE)
    film = Segment.attach(given.film)
    post = socket.socket(fileno=given.fd)
    with suppress(ConnectionError, BrokenPipeError):  # nobody listens any more
        serve(post, decode_film(bytes(film.view)), Segment.attach(given.pixels).view)


if __name__ == "__main__":
    main(sys.argv[1:])
