"""A world composed: parts and robots attached to one document, with the physics that its file says."""

import math
from collections.abc import Callable, Collection, Mapping
from copy import copy
from dataclasses import replace

import mujoco
import numpy as np

from onika.model.robot import RobotText
from onika.model.world import CONES, PlaceBlock, Spot
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of
from onika.workcell.composed.camera_spec import add_cameras, add_sky
from onika.workcell.composed.model_fault import ModelFault
from onika.workcell.composed.robot_model import HAND, ORIGIN, RobotModel, compiled, robot_model, robot_spec
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.composed.usable_parts import misplaced, part_spec, prefix_of, usable_parts

_PAPER = (0.96, 0.945, 0.912, 1.0)  # the colour of floors

_FIRST_BIT, _MOST_ALOOF = 16, 12
"""Which bits of contact tell places apart, of robots that do not touch themselves."""

_LARGEST_KEPT = 4 * 2**20
"""Bytes of a model that is kept once it is compiled; one with large meshes is compiled each time it is wanted."""

_BINARY = "world.mjb"

NOTHING = ""
"""In place of a robot where none stands."""

PlaceHand = tuple[str, str] | None
"""The hand of a place, a robot, and the site at which it is."""

Offsets = Mapping[str, tuple[float, float]]
"""How far parts stand from their spots, on x and y (m)."""


class Composition:
    """The world of some files, with all `faults` of them; raises ValueError where nothing can be made."""

    def __init__(self, sources: SourceTexts) -> None:
        self.sources = sources
        self.faults: list[Fault] = [*sources.faults]
        if sources.world is None:
            reason = self.faults[0].sentence if self.faults else Reason.of("workcell.no_world")
            raise ValueError(reason)
        self.world = sources.world
        usable = usable_parts(sources, self.world.parts, self.faults)
        self.parts, self._sites, self._lost = usable.parts, usable.sites, {**usable.lost}
        self._models: dict[object, mujoco.MjModel] = {}
        self._ahead: dict[object, mujoco.MjModel] = {}
        self._robots: dict[tuple[str, PlaceHand], RobotModel | None] = {}
        self._unusable: dict[str, tuple[Place, ...]] = {}
        self.places = tuple(place for place in self.world.places if self._is_used(place))
        self.standing = {place.name: NOTHING if place.is_empty else self.at(place)[0] for place in self.places}

    def at(self, place: PlaceBlock) -> tuple[str, ...]:
        """The robots of a place that can be used."""
        return tuple(robot for robot in place.robots if self._robot(place, robot) is not None)

    def robot(self, place: PlaceBlock, name: str) -> RobotModel:
        """One of them, with the hand that the place has; raises KeyError where it cannot be used."""
        model = self._robot(place, name)
        if model is None:
            raise KeyError(name)
        return model

    def hand(self, place: PlaceBlock) -> RobotModel | None:
        """The hand of a place by itself."""
        if place.hand is None:
            return None
        model = self._model(place, place.hand[0], "HAND", None)
        if model is None or not any(facts.start for facts in model.joints):
            return model
        self._tell_hand(place, Reason.of("workcell.hand_is_arm", name=place.hand[0]))
        return None

    def lost(self, *names: str) -> tuple[Place, ...]:
        """Where it is told that parts, places or devices of these names cannot be used, or what elements belong to."""
        return tuple(place for name in names for place in self._lost.get(name.partition(".")[0], ()))

    def leave_out(self, name: str, line: int, reason: Reason, because: tuple[Place, ...] = ()) -> None:
        """A device of the world that cannot be used, for what stands at a line of its file."""
        place, instead = Place(self.sources.place.file, line), Reason.of("workcell.device_left_out", name=name)
        self.faults.append(Fault(place, reason, instead, because=because))
        self._lost[name] = (place,)

    def names_of(
        self, exchanged: Collection[str], before: Mapping[str, str], now: Mapping[str, str]
    ) -> Callable[[str], bool]:
        """Whether a name is that of a robot of another model than stood at its place; the hand of a place stays."""
        places = [place for place in self.places if place.name in exchanged]
        changed = [
            place
            for place in places
            if before[place.name] == NOTHING
            or self.robot(place, before[place.name]).robot.models != self.robot(place, now[place.name]).robot.models
        ]
        prefixes = tuple(prefix_of(place.name) for place in changed)
        staying = tuple(prefix_of(place.name) + HAND for place in changed if place.hand is not None)
        return lambda name: name.startswith(prefixes) and not (staying and name.startswith(staying))

    def compile(self, standing: Mapping[str, str], offsets: Offsets, *, is_drawn: bool) -> mujoco.MjModel:
        """The model with these robots at their places; raises ValueError with the reason why there is none.

        Where nobody looks, shapes that are only drawn are left out, unless a robot's inertia is said to be theirs.
        """
        key = _key(standing, offsets, is_drawn=is_drawn)
        if key in self._models:
            return copy(self._models[key])
        model = self._ahead.pop(key, None) or self._compiled_world(standing, offsets, is_drawn=is_drawn)
        if mujoco.mj_sizeModel(model) <= _LARGEST_KEPT:
            self._models[key] = copy(model)  # whoever gets one may change it
        return model

    def is_kept(self, standing: Mapping[str, str], offsets: Offsets) -> bool:
        """Whether the model is at hand, where nobody looks."""
        return _key(standing, offsets, is_drawn=False) in self._models

    def binary(self, standing: Mapping[str, str], offsets: Offsets) -> bytes:
        """The same model for another copy of this process; raises ValueError with the reason why there is none."""
        model = self.compile(standing, offsets, is_drawn=False)
        written = np.empty(mujoco.mj_sizeModel(model), np.uint8)
        mujoco.mj_saveModel(model, None, written)
        return written.tobytes()

    def keep_ahead(self, standing: Mapping[str, str], offsets: Offsets, binary: bytes) -> None:
        """Have at hand what another copy has compiled, until it is wanted next; only the last one is kept."""
        model = mujoco.MjModel.from_binary_path(_BINARY, {_BINARY: binary})
        self._ahead = {_key(standing, offsets, is_drawn=False): model}

    def _compiled_world(self, standing: Mapping[str, str], offsets: Offsets, *, is_drawn: bool) -> mujoco.MjModel:
        try:
            return compiled(self._spec(standing, offsets, is_drawn=is_drawn))
        except ValueError:
            if is_drawn:
                raise
            return compiled(self._spec(standing, offsets, is_drawn=True))

    def _spec(self, standing: Mapping[str, str], offsets: Offsets, *, is_drawn: bool) -> mujoco.MjSpec:
        spec = mujoco.MjSpec()
        spec.modelname = self.world.name
        self._set_physics(spec)
        spec.compiler.discardvisual = not is_drawn
        for part in self.parts:
            child, offset = part_spec(self.sources, part), offsets.get(part.name, (0.0, 0.0))
            self._attach(spec, child, part.spot, part.name, offset)
        for place in self.places:
            if standing[place.name] != NOTHING:
                self._attach_robot(spec, place, self.robot(place, standing[place.name]))
        add_cameras(spec, self.world.cameras)
        if is_drawn:
            add_sky(spec)
        return spec

    def _robot(self, place: PlaceBlock, name: str) -> RobotModel | None:
        hand = place.hand if place.hand is not None and self.hand(place) is not None else None
        return self._model(place, name, "ROBOTS", hand)

    def _model(self, place: PlaceBlock, name: str, keyword: str, hand: PlaceHand) -> RobotModel | None:
        """A robot with a hand or without; None, and told once, where it cannot be used."""
        if (name, hand) in self._robots:
            return self._robots[name, hand]
        robot, model, before = self.sources.robots.get(name), None, len(self.faults)
        if robot is not None:
            model = self._compiled(place, robot, hand)
        elif self.sources.files.find(f"robot/{name}.robot") is None:
            where = Place(self.sources.place.file, place.lines.get(keyword, 0))
            reason = Reason.of("workcell.robot_missing", name=name)
            self.faults.append(Fault(where, reason, Reason.of("workcell.robot_left_out", name=name)))
        self._robots[name, hand] = model
        if model is None:
            of_text = (fault for fault in self.faults if fault.place.file == self.sources.robot_place(name).file)
            self._unusable[name] = tuple(fault.place for fault in (*of_text, *self.faults[before:]))
        return model

    def _compiled(self, place: PlaceBlock, robot: RobotText, hand: PlaceHand) -> RobotModel | None:
        if hand is None:
            return robot_model(self.sources, robot, self.faults)
        unfit = self._without_room(robot, hand[1])
        if unfit is not None:
            self._tell_hand(place, unfit)
            return None
        file = self.sources.robots[hand[0]].file
        return robot_model(self.sources, replace(robot, hand=file, on=hand[1]), self.faults)

    def _without_room(self, robot: RobotText, site: str) -> Reason | None:
        """Why a robot cannot bear the hand of a place at this site."""
        if robot.hand or robot.links:
            return Reason.of("workcell.hand_twice", name=robot.name)
        try:
            there = tuple(each.name for each in robot_spec(self.sources, robot).sites if each.name != ORIGIN)
        except ValueError:
            return None  # its file is told of
        return (
            None
            if site in there
            else Reason.of("workcell.no_such_name", there=there or Reason.of("workcell.none"), name=site)
        )

    def _tell_hand(self, place: PlaceBlock, reason: Reason) -> None:
        where = Place(self.sources.place.file, place.lines.get("HAND", 0))
        fault = Fault(where, reason, Reason.of("files.robot_left_out"))
        self.faults += [] if fault in self.faults else [fault]

    def _is_used(self, place: PlaceBlock) -> bool:
        wrong = misplaced(place.spot, self._sites)
        if wrong is None and self.at(place):
            self._sites |= set() if place.is_empty else self._sites_at(place)
            return True
        keyword, reason = wrong or ("PLACE", Reason.of("workcell.place_empty", place=place.name))
        where = Place(self.sources.place.file, place.lines.get(keyword, 0))
        robots = (*place.robots, *(place.hand[:1] if place.hand else ()))
        because = (*self.lost(place.spot.on), *(each for name in robots for each in self._unusable.get(name, ())))
        self.faults.append(Fault(where, reason, Reason.of("workcell.place_left_out"), because=because))
        self._lost[place.name] = (where,)
        return False

    def _sites_at(self, place: PlaceBlock) -> set[str]:
        """What may stand on the robot that stands there at first."""
        robot = self.robot(place, self.at(place)[0]).robot
        return {prefix_of(place.name) + site.name for site in robot_spec(self.sources, robot).sites}

    def _set_physics(self, spec: mujoco.MjSpec) -> None:
        option, (cone, ratio) = spec.option, self.world.contact
        option.timestep, option.gravity = self.world.step_s, (0.0, 0.0, -self.world.gravity)
        option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
        option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC if cone == CONES[1] else mujoco.mjtCone.mjCONE_PYRAMIDAL
        option.impratio, option.iterations = ratio, 50
        option.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_SENSOR)  # they are asked when someone wants to know
        spec.compiler.autolimits, spec.compiler.degree = True, False
        if self.world.floor is not None:
            plane, height = mujoco.mjtGeom.mjGEOM_PLANE, self.world.floor
            place, size = (0.0, 0.0, height), (0.0, 0.0, 0.05)
            spec.worldbody.add_geom(name="floor", type=plane, size=size, pos=place, rgba=_PAPER)

    def _attach_robot(self, spec: mujoco.MjSpec, place: PlaceBlock, robot: RobotModel) -> None:
        child = robot_spec(self.sources, robot.robot)
        for first, other in robot.excluded:
            child.add_exclude(bodyname1=first, bodyname2=other)
        _meet_others(child, self.places.index(place))
        self._attach(spec, child, place.spot, place.name, (0.0, 0.0))

    def _attach(
        self, spec: mujoco.MjSpec, child: mujoco.MjSpec, spot: Spot, name: str, offset: tuple[float, float]
    ) -> None:
        prefix = prefix_of(name)
        if not spot.on:
            x, y, z, turn = spot.at
            half = math.radians(turn) / 2.0
            quaternion = (math.cos(half), 0.0, 0.0, math.sin(half))
            frame = spec.worldbody.add_frame(pos=(x + offset[0], y + offset[1], z), quat=quaternion)
            spec.attach(child, frame=frame, prefix=prefix)
            return
        site = next((site for site in spec.sites if site.name == spot.on), None)
        if site is None:
            there = tuple(site.name for site in spec.sites)[:20] or Reason.of("workcell.none")
            raise ValueError(Reason.of("workcell.no_such_name", there=there, name=spot.on))
        spec.attach(child, site=site, prefix=prefix)


def _key(standing: Mapping[str, str], offsets: Offsets, *, is_drawn: bool) -> object:
    """Of what a model depends."""
    return tuple(standing.items()), tuple(offsets.items()), is_drawn


def _meet_others(child: mujoco.MjSpec, number: int) -> None:
    """Let a robot whose shapes do not touch each other, as their bits say, touch such robots at other places."""
    touching = [geom for geom in child.geoms if geom.contype or geom.conaffinity]
    meets_itself = any(one.contype & other.conaffinity for one in touching for other in touching)
    if meets_itself or number >= _MOST_ALOOF:
        return
    own = 1 << (_FIRST_BIT + number)
    every = ((1 << _MOST_ALOOF) - 1) << _FIRST_BIT
    for geom in touching:
        geom.contype |= own
        geom.conaffinity |= every & ~own


def why_not(wrong: ValueError, sources: SourceTexts) -> Fault:
    """What keeps a whole world from being made, as a fault of its file, or at the line of a model that is to blame."""
    if isinstance(wrong, ModelFault) and wrong.place.line:
        return Fault(wrong.place, reason_of(wrong), Reason.of("files.world_left_out"))
    return Fault(sources.place, reason_of(wrong), Reason.of("files.world_left_out"))
