"""The files of a world, gathered from the search path: its text, its robots, their models and what these need."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from onika.files import robot as robot_file, text, world as world_file
from onika.model.robot import RobotText
from onika.model.world import UNNAMED, PlaceBlock, WorldText
from onika.store.model_file import Needed, self_contained
from onika.store.opened_text import Faults
from onika.store.site import Site
from onika.wire.plan import PlannedTask
from onika.wire.world_source import WorldFile, WorldSource, digest_of
from onika.words.fault import Fault, Place
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

WORLD_FOLDER, ROBOT_FOLDER = "world", "robot"
_DEVICE = "DEVICE"


def world_path(name: str, site: Site) -> Path | None:
    """The file of a world, in the first base directory that holds it."""
    return _first(name, site, WORLD_FOLDER, world_file.ENDING)


def gather_world(name: str, site: Site) -> tuple[WorldSource | None, Faults]:
    """All files of a world, with what is wrong with them; None where there is no such world, or its text is at fault.

    A robot that is nowhere, or at fault, and a model that is nowhere, are lacking. Of a copy it is those of the world.
    """
    path = world_path(name.partition("@")[0], site)
    if path is None:
        return None, ()
    gathering = _Gathering(site)
    world = gathering.world(path)
    if world is None:
        return None, tuple(gathering.faults)
    files = (*gathering.files.values(), *gathering.needed.values())
    return WorldSource(world.name, digest_of(files), files), tuple(gathering.faults)


def sources_of(tasks: Iterable[PlannedTask], site: Site) -> tuple[tuple[WorldSource, ...], Faults]:
    """The files of the worlds in which tasks have devices, of those that are files, and what is wrong with them."""
    devices = (words[0] for task in tasks for key, words in task.local if key == _DEVICE and words)
    worlds = sorted({device.partition(":")[0].partition("@")[0] for device in devices})
    gathered = [gather_world(world, site) for world in worlds]
    sources = tuple(source for source, _ in gathered if source is not None)
    return sources, tuple(fault for _, faults in gathered for fault in faults)


def gather_robot(name: str, site: Site) -> tuple[WorldSource | None, Faults]:
    """A world in which nothing is but this robot, to be looked at; None where there is no such robot."""
    path = _first(name, site, ROBOT_FOLDER, robot_file.ENDING)
    if path is None:
        return None, ()
    gathering = _Gathering(site)
    gathering.robot(name)
    text_of_world = world_file.write(WorldText(name, blocks=(PlaceBlock(UNNAMED, (name,)),)))
    alone = WorldFile(f"{WORLD_FOLDER}/{name}{world_file.ENDING}", str(path), text_of_world.encode())
    files = (alone, *gathering.files.values(), *gathering.needed.values())
    return WorldSource(name, digest_of(files), files), tuple(gathering.faults)


class _Gathering:
    """Reads each file once."""

    def __init__(self, site: Site) -> None:
        self._site = site
        self.files: dict[str, WorldFile] = {}
        self.needed: dict[str, WorldFile] = {}
        self.faults: list[Fault] = []

    def world(self, path: Path) -> WorldText | None:
        """The text of a world, its parts and its robots."""
        content = self._text(path, f"{WORLD_FOLDER}/{path.name}")
        world, faults = world_file.read(content, path.stem, str(path)) if content is not None else (None, ())
        self.faults += faults
        if world is None:
            return None
        for part in world.parts:
            place = Place(str(path), part.lines.get("FILE", 0))
            self._model(path.parent, WORLD_FOLDER, part.file, place, Reason.of("files.world_left_out"))
        for name in world.robots:
            self.robot(name)
        return world

    def robot(self, name: str) -> None:
        """The text of a robot and its models; nothing where there is none."""
        path = _first(name, self._site, ROBOT_FOLDER, robot_file.ENDING)
        if path is None:
            return  # told of the place where it should stand
        content = self._text(path, f"{ROBOT_FOLDER}/{path.name}")
        robot, faults = robot_file.read(content, name, str(path)) if content is not None else (None, ())
        self.faults += faults
        for file, line in _models(robot):
            self._model(path.parent, ROBOT_FOLDER, file, Place(str(path), line), Reason.of("files.robot_left_out"))

    def _model(self, folder: Path, kind: str, file: str, place: Place, instead: Reason) -> None:
        """A model that a text names, and what it needs."""
        path = folder / file
        if not path.is_file():
            self.faults.append(Fault(place, Reason.of("store.model_nowhere", file=file), instead))
            return
        content, needed, faults = self_contained(path)
        self.faults += faults
        if content is not None:
            self.files[f"{kind}/{file}"] = WorldFile(f"{kind}/{file}", str(path), content)
            self.needed |= {one.name: _file(one) for one in needed}

    def _text(self, path: Path, name: str) -> str | None:
        content, faults = text.load(path, str(path))
        self.faults += faults
        if content is not None:
            self.files[name] = WorldFile(name, str(path), content.encode())
        return content


def _models(robot: RobotText | None) -> Iterator[tuple[str, int]]:
    """The models of a robot, each with its line."""
    if robot is not None:
        yield robot.file, robot.lines.get("FILE", 0)
        for link in dict.fromkeys(robot.links):
            yield link, robot.lines.get("LINKS", 0)
        if robot.hand:
            yield robot.hand, robot.lines.get("HAND", 0)


def _file(needed: Needed) -> WorldFile:
    return WorldFile(needed.name, str(needed.path), needed.content)


def _first(name: str, site: Site, folder: str, ending: str) -> Path | None:
    if not TASK_NAME.match(name):
        return None
    paths = (base.path / folder / (name + ending) for base in site.directories)
    return next((path for path in paths if path.is_file()), None)
