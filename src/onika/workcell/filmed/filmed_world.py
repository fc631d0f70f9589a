"""A world that is files, with its cameras (requirement F05)."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from onika.model.camera import CameraBlock
from onika.ring.device import DriveEvent
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault
from onika.words.reason import Reason
from onika.workcell.cell.file_world import FileWorld
from onika.workcell.composed.camera_spec import eye_of, focal_length, is_placed, lenses
from onika.workcell.composed.camera_unit import CameraUnit
from onika.workcell.composed.composition import why_not
from onika.workcell.composed.device_names import device_name
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.composed.usable_parts import prefix_of
from onika.workcell.filmed.filming import Filming

MOST = 8
"""Cameras of a world; their pictures have to find room on its bus."""


class FilmedWorld(FileWorld):
    """The world of these files and its cameras; raises ValueError with the first reason where there is none."""

    def __init__(self, files: WorldSource, seed: int | None = None) -> None:
        self._cameras: tuple[CameraUnit, ...] = ()
        super().__init__(files, seed)
        self._films = _films(files, self._cameras)

    def render_in_step(self) -> None:
        """From now on each picture is there at its instant: the world waits for it, in virtual time."""
        for film in self._films:
            film.wait()

    def look(self, device: str, is_wanted: bool) -> None:
        """Tasks use the pictures of a camera from now on, or none does any more."""
        next(film for film in self._films if film.has(device)).use(device, is_wanted, self.now_ns)

    def show(self, device: str, is_shown: bool) -> None:
        """Somebody looks at the pictures of a camera from now on, or nobody any more; nothing for another device."""
        for film in self._films:
            film.show(device, is_shown, self.now_ns)

    def take_small(self) -> dict[str, tuple[int, int, bytes]]:
        """Of cameras at which somebody looks the newest picture since the last call: number, when (ns), JPEG or PNG."""
        return {device: small for film in self._films for device, small in film.take_small().items()}

    def picture(self, device: str) -> npt.NDArray[np.uint8]:
        """The newest picture of a camera, uint8[H,W,3]; the same array always."""
        return next(unit.pixels for unit in self._cameras if unit.sheet.name == device)

    def step(self, until_ns: int) -> None:
        """As any world; the cameras take their pictures between two steps, at their instants."""
        if not self._films:
            super().step(until_ns)
            return
        while (due_ns := min(film.due_ns for film in self._films)) <= until_ns:
            super().step(due_ns)
            for film in self._films:
                film.expose(max(self.now_ns, due_ns), self._plant, dict(self._stands.acting), self.lit)
        super().step(until_ns)
        for film in self._films:
            film.take_in(self.now_ns)

    def take_events(self) -> list[DriveEvent]:
        """The changes of drives since the last call, and of cameras."""
        if not self._films:
            return super().take_events()
        return [*super().take_events(), *(event for film in self._films for event in film.take_events())]

    def _more_units(self) -> Sequence[CameraUnit]:
        cameras = [*self._of_world(), *self._of_robots()]
        for unit in cameras[MOST:]:
            self._composition.leave_out(unit.sheet.name, 0, Reason.of("workcell.many_cameras", most=MOST))
        self._cameras = tuple(cameras[:MOST])
        return self._cameras

    def _of_world(self) -> Iterator[CameraUnit]:
        there = lenses(self._plant.model)
        for camera in self._composition.world.cameras:
            eye = eye_of(camera)
            if camera.device:
                yield CameraUnit(camera.name, camera, "", focal_length(camera.lens, camera.size[1]))
            elif eye in there:
                yield CameraUnit(camera.name, camera, eye, focal_length(there[eye], camera.size[1]))
            else:
                reason, keyword = _lacking(camera, there)
                because = self._composition.lost(camera.on, camera.view)
                self._composition.leave_out(camera.name, camera.lines.get(keyword, 0), reason, because)

    def _of_robots(self) -> Iterator[CameraUnit]:
        for place in self._composition.places:
            models = [self._composition.robot(place, name) for name in self._composition.at(place)]
            there = [model.robot for model in models]
            for robot, model in zip(there, models, strict=True):
                for camera in robot.cameras:
                    eye, name = eye_of(camera), device_name(camera, robot, there, place.name)
                    if camera.device:
                        yield CameraUnit(name, camera, "", focal_length(camera.lens, camera.size[1]), place.name)
                    elif eye in model.lenses:
                        focal = focal_length(model.lenses[eye], camera.size[1])
                        yield CameraUnit(name, camera, prefix_of(place.name) + eye, focal, place.name)
                    else:
                        reason, keyword = _lacking(camera, model.lenses)
                        where = self._composition.sources.robot_place(robot.name, camera.lines.get(keyword, 0))
                        instead = Reason.of("workcell.device_left_out", name=camera.name)
                        self._composition.faults.append(Fault(where, reason, instead))


def _films(files: WorldSource, cameras: Sequence[CameraUnit]) -> tuple[Filming, ...]:
    """All cameras that are rendered together, and each real one by itself."""
    rendered = [unit for unit in cameras if not unit.source]
    together = (Filming(files, rendered),) if rendered else ()
    return *together, *(Filming(files, [unit]) for unit in cameras if unit.source)


def judged(files: WorldSource) -> tuple[Fault, ...]:
    """All that is wrong with the files of a world, and what is left out for that."""
    sources = SourceTexts(files)
    try:
        return FilmedWorld(files).faults
    except ValueError as wrong:
        others = tuple(sources.faults)
        return others or (why_not(wrong, sources),)


def _lacking(camera: CameraBlock, there: Mapping[str, float]) -> tuple[Reason, str]:
    """Why a camera cannot be used, and the line of its block that says so."""
    if camera.at:
        return Reason.of("workcell.no_body_for_camera", name=camera.on), "ON"
    names = tuple(name for name in there if not is_placed(name))[:20] or Reason.of("workcell.none")
    reason = Reason.of("workcell.no_such_name", there=names, name=camera.view or camera.name)
    return reason, "VIEW" if camera.view else "CAMERA"
