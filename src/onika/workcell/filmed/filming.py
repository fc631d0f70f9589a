"""The cameras of one world at work: when each takes a picture, who renders it, and that it has come."""

from collections.abc import Sequence
from typing import Any

import mujoco

from onika.ring.device import DriveEvent, DriveState
from onika.ring.drive import NEVER_NS
from onika.ring.segment import SharedMemoryRefused
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason, reason_of
from onika.workcell.composed.camera_unit import CameraUnit
from onika.workcell.filmed.camera_messages import Exposed, Exposure, Film, laid_out
from onika.workcell.filmed.camera_renderer import WAYS, CameraRenderer
from onika.workcell.plant import Plant

_PATIENCE_S = 30.0


class Filming:
    """Nothing is rendered, and no process is there, as long as nobody wants a picture.

    `waits` lets each picture be there at its instant, as virtual time needs it; else they come when they are ready, and
    what a camera would have taken meanwhile is left out. A real camera is filmed by itself: nobody waits for it.
    """

    def __init__(self, files: WorldSource, cameras: Sequence[CameraUnit], ways: tuple[str, ...] = WAYS) -> None:
        self._source = cameras[0].source if cameras else ""
        self._files, self._ways = WorldSource(files.world, files.digest, ()) if self._source else files, ways
        self._cameras = tuple(cameras)
        self._numbers = {unit.sheet.name: number for number, unit in enumerate(self._cameras)}
        self._used: set[str] = set()
        self._shown: set[str] = set()
        self._renderer: CameraRenderer | None = None
        self._events: list[DriveEvent] = []
        self._small: dict[str, tuple[int, int, bytes]] = {}
        self.waits = False
        self._is_out_of_time = False
        self.due_ns = NEVER_NS
        """When the next picture is to be taken."""

    def wait(self) -> None:
        """From now on each picture is there at its instant; a real camera that films now has none of virtual time."""
        self.waits = True
        self._is_out_of_time = is_live(self._source)

    def has(self, device: str) -> bool:
        """Whether this camera is filmed here."""
        return device in self._numbers

    def use(self, device: str, is_used: bool, now_ns: int) -> None:
        """Tasks use the pictures of this camera from now on, or none does any more."""
        self._want(self._used, device, is_used, now_ns)

    def show(self, device: str, is_shown: bool, now_ns: int) -> None:
        """Somebody looks at the pictures of this camera from now on, or nobody any more."""
        if device in self._numbers:
            self._want(self._shown, device, is_shown, now_ns)

    def expose(self, now_ns: int, plant: Plant, standing: dict[str, str], lit: tuple[str, ...]) -> None:
        """Let the cameras that are due take a picture of this instant."""
        for number, unit in enumerate(self._cameras):
            if unit.due_ns > now_ns:
                continue
            unit.schedule(now_ns)
            is_there = self._source or mujoco.mj_name2id(plant.model, mujoco.mjtObj.mjOBJ_CAMERA, unit.eye) >= 0
            if self._renderer is not None and is_there and number not in self._renderer.owed:
                is_shown = unit.sheet.name in self._shown
                qpos: Any = plant.data.qpos
                self._renderer.ask(Exposure(number, now_ns, standing, qpos.tobytes(), lit, is_shown))
        self._note_due()
        while self.waits and self._renderer is not None and self._renderer.owed:
            if not self.take_in(now_ns, _PATIENCE_S):
                self._darken(Reason.of("workcell.no_graphics", why=Reason.of("workcell.no_picture_came")), now_ns)

    def take_in(self, now_ns: int, patience_s: float = 0.0) -> bool:
        """Take the pictures that have come; whether any has."""
        if self._renderer is None or not self._renderer.owed:
            return False
        answers = [*self._renderer.answers(patience_s)]
        for answer in answers:
            if answer.why is not None:
                self._darken(answer.why, now_ns)
                break
            self._take(answer, now_ns)
        return bool(answers)

    def take_events(self) -> list[DriveEvent]:
        """That cameras can take no pictures, and why, since the last call."""
        events, self._events = self._events, []
        return events

    def take_small(self) -> dict[str, tuple[int, int, bytes]]:
        """The newest picture that is shown of each camera since the last call: number, when, JPEG or PNG."""
        small, self._small = self._small, {}
        return small

    def _take(self, answer: Exposed, now_ns: int) -> None:
        unit = self._cameras[answer.eye]
        if self._renderer is not None:
            unit.take(self._renderer.pixels[answer.eye], answer.taken_ns, now_ns)
        if answer.small:
            self._small[unit.sheet.name] = int(unit.state[2]), answer.taken_ns, answer.small

    def _want(self, who: set[str], device: str, is_wanted: bool, now_ns: int) -> None:
        unit = self._cameras[self._numbers[device]]
        if is_wanted:
            who.add(device)
        else:
            who.discard(device)
        wanted = self._used | self._shown
        if device not in wanted:
            unit.rest()
        elif unit.due_ns == NEVER_NS and not unit.is_dark:
            unit.schedule(now_ns - 1)
            self._begin(now_ns)
        if not wanted and self._renderer is not None:
            self._renderer.close()
            self._renderer = None
        self._note_due()

    def _begin(self, now_ns: int) -> None:
        if self._is_out_of_time:
            self._darken(Reason.of("workcell.camera_out_of_time"), now_ns)
        elif self._renderer is None:
            eyes = laid_out([(unit.eye, unit.sheet.picture) for unit in self._cameras])
            try:
                self._renderer = CameraRenderer(Film(self._files, eyes, self._source), self._ways)
            except SharedMemoryRefused as refused:
                self._darken(reason_of(refused), now_ns)

    def _darken(self, why: Reason, now_ns: int) -> None:
        """Nothing can be rendered: every camera that is wanted says so once."""
        if self._renderer is not None:
            self._renderer.close()
            self._renderer = None
        for device in sorted(self._used | self._shown):
            unit = self._cameras[self._numbers[device]]
            if not unit.is_dark:
                unit.darken()
                self._events.append(DriveEvent(device, int(DriveState.TRIPPED), now_ns, now_ns, -1, why))
        self._note_due()

    def _note_due(self) -> None:
        self.due_ns = min((unit.due_ns for unit in self._cameras), default=NEVER_NS)


def is_live(source: str) -> bool:
    """Whether a source is a device, which shows what is now; a film and a row of pictures are the same each time."""
    return source.isdecimal() or source.startswith("/dev/")
