"""Renders for the cameras of a world: `python -m onika.workcell.filmed.camera_process --fd N --film N --pixels N`.

A process of its own, of low priority and in one thread, so that no control cycle waits for a picture (decision 50). It
ends with the other end of its socket. MUJOCO_GL says in which way it draws.
"""

import argparse
import os
import signal
import socket
import sys
from contextlib import suppress
from typing import Any

import mujoco
import numpy as np
import numpy.typing as npt

from onika.ring.segment import Segment
from onika.words.reason import Reason
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.filmed.camera_messages import (
    Exposed,
    Exposure,
    Eye,
    Film,
    decode_exposure,
    decode_film,
    encode,
)
from onika.workcell.filmed.small_picture import small_picture
from onika.workcell.scene import looked_at_numbers

NICE = 10
_LARGEST = 1 << 20  # bytes of an order
_UNSEEN = 5  # a group of shapes that is not drawn
_SHINING = (1.0, 0.95, 0.7, 1.0)
_AMBIENT, _DIFFUSE = 0.5, 0.4  # of a lamp at the eye, without gloss: colours stay what they are

Pixels = npt.NDArray[np.uint8]


class RenderedWorld:
    """The world of a film, as its cameras see it. Raises whatever a graphics driver or its loader raises."""

    def __init__(self, film: Film, memory: memoryview) -> None:
        mujoco.set_mju_user_warning(_unlogged)
        self._composition = Composition(SourceTexts(film.files))
        self._eyes = film.eyes
        self._pixels = [_pixels(memory, eye) for eye in film.eyes]
        self._standing: dict[str, str] | None = None
        self._renderers: dict[tuple[int, int], Any] = {}
        self._option = mujoco.MjvOption()
        self._option.sitegroup[:] = 0

    def expose(self, exposure: Exposure) -> Exposed:
        """Render one picture into its place."""
        if exposure.standing != self._standing:
            self._stand(exposure.standing)
        model, data, eye = self._model, self._data, self._eyes[exposure.eye]
        data.qpos[:] = np.frombuffer(exposure.qpos)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_camlight(model, data)
        self._shine(exposure.lit)
        renderer, pixels = self._renderer(eye), self._pixels[exposure.eye]
        renderer.update_scene(data, eye.name, self._option)
        renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = 0
        renderer.scene.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = 0
        renderer.render(out=pixels)
        return Exposed(exposure.eye, exposure.taken_ns, small_picture(pixels) if exposure.is_shown else b"")

    def close(self) -> None:
        """Give the graphics back."""
        for renderer in self._renderers.values():
            renderer.close()
        self._renderers.clear()

    def _stand(self, standing: dict[str, str]) -> None:
        """Compile the world with other robots at its places."""
        self.close()
        model = self._composition.compile(standing, {}, is_drawn=True)
        unseen = sorted(set(range(model.ngeom)) - set(looked_at_numbers(model)))
        model.geom_group[unseen] = _UNSEEN
        model.vis.quality.offsamples = 0
        model.vis.global_.offwidth = max(eye.width for eye in self._eyes)
        model.vis.global_.offheight = max(eye.height for eye in self._eyes)
        model.vis.headlight.ambient[:], model.vis.headlight.diffuse[:] = _AMBIENT, _DIFFUSE
        model.vis.headlight.specular[:] = 0.0
        self._model, self._data, self._standing = model, mujoco.MjData(model), standing
        self._lit: tuple[str, ...] = ()
        self._colours = model.geom_rgba.copy()
        self._materials = model.geom_matid.copy()

    def _shine(self, lit: tuple[str, ...]) -> None:
        """Give the shapes that shine their light, and the others their colours."""
        if lit == self._lit:
            return
        self._model.geom_rgba[:], self._model.geom_matid[:] = self._colours, self._materials
        for name in lit:
            shape = mujoco.mj_name2id(self._model, mujoco.mjtObj.mjOBJ_GEOM, name)
            if shape >= 0:
                self._model.geom_rgba[shape], self._model.geom_matid[shape] = _SHINING, -1
        self._lit = lit

    def _renderer(self, eye: Eye) -> Any:
        size = eye.height, eye.width
        if size not in self._renderers:
            self._renderers[size] = mujoco.Renderer(self._model, *size)
        return self._renderers[size]


def serve(post: socket.socket, film: Film, memory: memoryview) -> None:
    """Answer each order until nobody gives any more; after a failure only why it failed."""
    world: RenderedWorld | None = None
    why: Reason | None = None
    while order := post.recv(_LARGEST):
        exposure = decode_exposure(order)
        answer = Exposed(exposure.eye, exposure.taken_ns, why=why)
        if why is None:
            try:
                world = world or RenderedWorld(film, memory)
                answer = world.expose(exposure)
            # whatever a graphics driver or its loader raises means the same here
            except Exception as fault:
                why = Reason.plain(" ".join(f"{os.environ.get('MUJOCO_GL', '')}: {fault}".split())[:200].rstrip(". "))
                answer = Exposed(exposure.eye, exposure.taken_ns, why=why)
        post.send(encode(answer))
    if world is not None:
        world.close()


def _pixels(memory: memoryview, eye: Eye) -> Pixels:
    count = 3 * eye.width * eye.height
    return np.frombuffer(memory, np.uint8, count, eye.offset).reshape(eye.height, eye.width, 3)


def _unlogged(_text: str) -> None:
    """What MuJoCo warns of is of no use here."""


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
