"""The files of a world, read: what its texts say, and each model as a document of its own that can be attached."""

import re
from collections.abc import Iterator, Mapping
from pathlib import PurePath
from typing import Any

import mujoco

from onika.files import robot as robot_file, world as world_file
from onika.files.text import decode
from onika.model.robot import RobotText
from onika.model.world import WorldText
from onika.wire.world_source import WorldFile, WorldSource
from onika.words.fault import Fault, Place
from onika.words.reason import Reason
from onika.workcell.composed.model_fault import ModelFault, element_names, line_of, model_fault

MISSING = "missing"
"""What a model calls a file that it needs and that is not there."""

_REFERENCE = re.compile(rb"""\bfile\w*\s*=\s*["']([^"']*)["']""")
_MODELS = (".xml", ".mjcf", ".urdf")


class SourceTexts:
    """What is said by the files of one world; `faults` are those of its texts."""

    def __init__(self, files: WorldSource) -> None:
        self.files = files
        self.faults: list[Fault] = []
        self.world: WorldText | None = None
        self.robots: dict[str, RobotText] = {}
        self._specs: dict[str, mujoco.MjSpec] = {}
        self._needed = {file.name: file.content for file in files.files if "/" not in file.name}
        self._read()

    @property
    def place(self) -> Place:
        """The file of the world."""
        return self.place_of(f"world/{self.files.world}{world_file.ENDING}")

    def place_of(self, name: str, line: int = 0) -> Place:
        """Where a file was read; its name where it was not."""
        file = self.files.find(name)
        return Place(file.path if file else name, line)

    def robot_place(self, robot: str, line: int = 0) -> Place:
        """The file of a robot."""
        return self.place_of(f"robot/{robot}{robot_file.ENDING}", line)

    def model(self, name: str) -> mujoco.MjSpec:
        """A model by its name, a document of its own each time; raises ValueError with the reason why not."""
        if name in self._specs:
            return self._specs[name].copy()
        spec = self._parsed(name)
        if _counts(spec.copy()) == _counts(spec):  # a copy leaves out what refers to nothing, as no compiler would
            self._specs[name] = spec.copy()
        return spec

    def model_fault(self, reason: Reason, models: Mapping[str, str]) -> ModelFault:
        """Why a document cannot be used, at the line of that of its models which is meant.

        models   by what stands before their names in the document; the first one where none of these is meant
        """
        names, first = [*element_names(reason)], next(iter(models))
        meant = (prefix for prefix in models if prefix and any(name.startswith(prefix) for name in names))
        prefix = next(meant, first)
        file = self.files.find(models[prefix])
        if file is None:
            return ModelFault(reason, Place(models[prefix]))
        return model_fault(reason, [file, *self._included(file)], prefix)

    def _included(self, model: WorldFile) -> Iterator[WorldFile]:
        """The files of which a model is made beside its own."""
        references = {reference.decode("utf-8", "replace") for reference in _REFERENCE.findall(model.content)}
        for file in self.files.files:
            if file.name in references and file.name.endswith(_MODELS):
                yield file
                yield from self._included(file)

    def _parsed(self, name: str) -> mujoco.MjSpec:
        file = self.files.find(name)
        if file is None:
            raise ValueError(Reason.of("workcell.model_missing", name=name))
        self._refuse_strangers(file)
        try:
            text, needed = file.content.decode(), self._needed
            spec = mujoco.MjSpec.from_string(text, include=needed, assets=needed)
        except (ValueError, RuntimeError) as wrong:
            raise self.model_fault(Reason.of("workcell.model_unreadable", why=first_line(wrong)), {"": name}) from None
        _drop_missing(spec)
        return spec

    def _read(self) -> None:
        for file in self.files.files:
            path = PurePath(file.name)
            if path.suffix not in (robot_file.ENDING, world_file.ENDING):
                continue
            text, faults = decode(file.content, file.path)
            self.faults += faults
            if text is None:
                continue
            if path.suffix == world_file.ENDING:
                self.world, faults = world_file.read(text, path.stem, file.path)
            else:
                robot, faults = robot_file.read(text, path.stem, file.path)
                self.robots |= {path.stem: robot} if robot else {}
            self.faults += faults

    def _refuse_strangers(self, file: WorldFile) -> None:
        """A model reads nothing of this machine, only what came with it."""
        for content in (file.content, *(self._needed[name] for name in self._needed if name.endswith(_MODELS))):
            for reference in _REFERENCE.findall(content):
                name = reference.decode("utf-8", "replace")
                if name and name not in self._needed and not name.startswith(MISSING):
                    reason = Reason.of("workcell.model_reference", name=name)
                    raise ModelFault(reason, Place(file.path, line_of(file, name, r"file\w*")))


def first_line(wrong: Exception) -> Reason:
    """What MuJoCo says of a model, on one line."""
    return Reason.plain(" ".join(str(wrong).split())[:300])


def _counts(spec: mujoco.MjSpec) -> list[int]:
    """How many of each kind of element that may refer to others."""
    kinds = (spec.geoms, spec.sites, spec.joints, spec.tendons, spec.actuators, spec.sensors, spec.equalities)
    return [len(elements) for elements in (*kinds, spec.excludes, spec.pairs, spec.skins, spec.keys)]


def _drop_missing(spec: mujoco.MjSpec) -> None:
    """Meshes and fields of heights that are not there, with the shapes made of them, and textures."""
    gone = [made for made in (*spec.meshes, *spec.hfields) if made.file.startswith(MISSING)]
    textures = [texture for texture in spec.textures if any(file.startswith(MISSING) for file in _files(texture))]
    if gone or textures:
        _drop(spec, gone, textures)


def _drop(spec: mujoco.MjSpec, gone: list[Any], textures: list[Any]) -> None:
    names = {made.name for made in gone}
    for geom in [geom for geom in spec.geoms if geom.meshname in names or geom.hfieldname in names]:
        spec.delete(geom)
    unpainted = {texture.name for texture in textures}
    for material in spec.materials:
        for role, name in enumerate(material.textures):
            if name in unpainted:
                material.textures[role] = ""
    for made in (*gone, *textures):
        spec.delete(made)


def _files(texture: Any) -> Iterator[str]:
    """What a texture is read from: one file, or one for each side."""
    yield texture.file
    yield from texture.cubefiles
