"""The model of a robot with all files that it needs, as it comes into a base directory (requirement X19)."""

import os
from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

from onika.store.model_file import Needed, self_contained
from onika.store.motor_repair import with_motors
from onika.store.urdf_repair import ABSENT, repaired
from onika.wire.world_source import WorldFile, WorldSource, digest_of
from onika.words.reason import Reason

ROBOTS = "robot"
_URDF = ".urdf"


@dataclass(frozen=True, slots=True)
class RobotPackage:
    """A model on its way into a base directory.

    file       the model, from the folder `robot` on
    contents   files to be written, by their paths in the base directory
    source     the same as something that is sent, without a world and a description
    origins    where the files that it needs were read, by their names in `source`
    notes      what was repaired, or is lacking
    lacks      the files that are not there
    """

    file: str
    contents: Mapping[str, bytes]
    source: WorldSource
    origins: Mapping[str, Path]
    notes: tuple[Reason, ...]
    lacks: tuple[Reason, ...] = ()


def package(
    path: Path, name: str, base: Path, dropped: Set[Path] = frozenset(), undriven: Sequence[str] = ()
) -> RobotPackage:
    """The model at a path for the robot `name` in a base directory; raises ValueError with the reason why not.

    A model in MJCF that lies in the base directory stays there as it is, of another one the joints `undriven` get
    motors; a URDF is repaired, without the meshes `dropped`.
    """
    if path.suffix.lower() == _URDF:
        return _urdf(path, name, dropped)
    content, needed, faults = self_contained(path)
    if content is None:
        raise ValueError(Reason.of("store.robot_unreadable", place=str(faults[0].place), reason=faults[0].reason))
    notes = tuple(fault.sentence for fault in faults)
    robots = (base / ROBOTS).resolve()
    if path.resolve().is_relative_to(robots):
        file = path.resolve().relative_to(robots).as_posix()
        return _packaged(name, file, {}, (path, content), needed, notes, notes)
    where = {Path(os.path.normpath(one.path)): one.path.read_bytes() for one in needed}
    where[path.resolve()] = path.read_bytes()
    lacks = notes
    if undriven:
        content, where[path.resolve()] = (with_motors(text, undriven) for text in (content, where[path.resolve()]))
        notes = (*notes, Reason.of("store.robot_motors", joints=tuple(undriven)))
    root = _root(where)
    contents = {f"{ROBOTS}/{name}/{file.relative_to(root).as_posix()}": data for file, data in where.items()}
    file = f"{name}/{path.resolve().relative_to(root).as_posix()}"
    return _packaged(name, file, contents, (path, content), needed, notes, lacks)


def _urdf(path: Path, name: str, dropped: Set[Path]) -> RobotPackage:
    repair = repaired(path, dropped)
    root = _root(repair.meshes.values())
    places = {file: _place(name, file.relative_to(root), file in repair.converted) for file in repair.meshes.values()}
    text = repair.text({given: places[file] for given, file in repair.meshes.items()})
    contents = {
        f"{ROBOTS}/{place}": repair.converted[file] if file in repair.converted else file.read_bytes()
        for file, place in places.items()
    }
    contents[f"{ROBOTS}/{name}{_URDF}"] = text
    with TemporaryDirectory() as folder:
        for place, data in contents.items():
            staged = Path(folder, place)
            staged.parent.mkdir(parents=True, exist_ok=True)
            staged.write_bytes(data)
        content, needed, faults = self_contained(Path(folder, ROBOTS, name + _URDF))
    if content is None:
        raise ValueError(Reason.of("store.robot_unreadable", place=str(faults[0].place), reason=faults[0].reason))
    lacks = tuple(note for note in repair.notes if note.key in ABSENT)
    made = _packaged(name, name + _URDF, contents, (path, content), needed, repair.notes, lacks)
    by_place = {Path(place).name: file for file, place in places.items()}
    origins = {one.name: by_place.get(one.path.name, one.path) for one in needed}
    return replace(made, origins=origins)


def _place(name: str, file: Path, is_converted: bool) -> str:
    """Where a mesh comes to lie; of one that is converted both endings stay, so that it is not another one's name."""
    return f"{name}/{file.as_posix()}" + (".obj" if is_converted else "")


def _packaged(
    name: str,
    file: str,
    contents: Mapping[str, bytes],
    model: tuple[Path, bytes],
    needed: tuple[Needed, ...],
    notes: tuple[Reason, ...],
    lacks: tuple[Reason, ...],
) -> RobotPackage:
    path, content = model
    files = (
        WorldFile(f"{ROBOTS}/{file}", str(path), content),
        *(WorldFile(one.name, str(one.path), one.content) for one in needed),
    )
    origins = {one.name: one.path for one in needed}
    return RobotPackage(file, contents, WorldSource(name, digest_of(files), files), origins, notes, lacks)


def _root(files: Iterable[Path]) -> Path:
    """The folder in which, at some depth, all files lie."""
    folders = [str(file.parent) for file in files]
    return Path(os.path.commonpath(folders)) if folders else Path("/")
