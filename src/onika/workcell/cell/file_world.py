"""A world that is files: what its `.world` file says, composed, stepped, and driven by name (requirement X19).

It is offered to a runtime under no name of its own: whoever plans with it sends its files (decision 49).
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import mujoco
from mujoco import mj_step

from onika.laws.frames import Array
from onika.model.world import ButtonBlock
from onika.ring.device import MishapEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveInput
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault
from onika.words.reason import Reason
from onika.workcell.cell.button_places import Place, button_places
from onika.workcell.cell.cell_devices import touched_switches, usable_lamps, usable_sensors
from onika.workcell.cell.cell_hands import CellHands
from onika.workcell.cell.cell_hindrance import CellHindrance
from onika.workcell.cell.cell_lookout import CellLookout
from onika.workcell.cell.cell_places import CellPlaces
from onika.workcell.cell.cell_scenes import CellScenes
from onika.workcell.cell.cell_thing import called
from onika.workcell.cell.robot_exchange import RobotExchange
from onika.workcell.composed import part_places
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.robot_unit import RobotUnit
from onika.workcell.composed.robot_units import robot_units
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.composed.stands import Stands
from onika.workcell.composed.still import still
from onika.workcell.driven_world import DrivenWorld
from onika.workcell.gripping.forceless import Forceless
from onika.workcell.gripping.loose_parts import LooseParts
from onika.workcell.panic_button import PanicButton
from onika.workcell.plant import Plant
from onika.workcell.scene import Shape3d
from onika.workcell.snapshot import WorldSnapshot, encode
from onika.workcell.unit import DeviceUnit

_UNSTABLE = (mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC)


class FileWorld(DrivenWorld):
    """The world of these files; raises ValueError with the first reason where there is none.

    `seed` moves each part that may stand a little elsewhere by up to what its file says, on x and y.
    """

    def __init__(self, files: WorldSource, seed: int | None = None) -> None:
        mujoco.set_mju_user_warning(_unlogged)  # else it writes into the folder of whoever runs it
        self._composition = Composition(SourceTexts(files))
        world = self._composition.world
        self.step_ns = round(world.step_s * 1e9)
        self._offsets = part_places.offsets(world.parts, seed)
        self._plant = Plant(self._compile(self._composition.standing, is_drawn=False))
        robots = {place.name: self._composition.at(place) for place in self._composition.places}
        units = [*robot_units(self._composition, self._model_with)]
        self._stands = Stands(robots, self._composition.standing, units)
        touched = touched_switches(world)
        lamps = usable_lamps(self._composition, self._plant.model, touched)
        self._lamps = sorted(lamps, key=lambda lamp: lamp.measures)  # what is measured overwrites what sensors feel
        self._scenes = CellScenes(self._composition, self._offsets, [lamp.lamp for lamp in self._lamps])
        sensors = usable_sensors(self._composition, self._plant.model)
        self._watching: list[DeviceUnit] = [*self._lamps, *sensors, *self._more_units()]
        buttons = [*self._panic_buttons(), *touched.values()]
        super().__init__([*self._stands.units, *self._watching], buttons)
        self._running: list[RobotUnit] = []
        self._forceless: Forceless | None = None
        self._lookout: CellLookout | None = None
        self._bind()
        for unit in self._present:
            unit.restart()
        self._start: Array = self._plant.data.qpos.copy()
        self._begin()

    @property
    def faults(self) -> tuple[Fault, ...]:
        """All that is wrong with its files, and left out for that."""
        return tuple(dict.fromkeys(self._composition.faults))

    def objections(self, devices: Sequence[str]) -> tuple[Reason, ...]:
        """Why these devices cannot be used together; none: they can."""
        return tuple(self._stands.objections(devices))

    def remarks(self, devices: Sequence[str]) -> tuple[Reason, ...]:
        """What is odd about these devices in one flow, and forbids nothing: hands, and arms that do not bear them."""
        return tuple(self._stands.remarks(devices))

    def preparation(self, device: str) -> RobotExchange | None:
        """What takes long before another robot may stand at its place; nothing: the device can be claimed."""
        unit = next((unit for unit in self._stands.units if unit.sheet.name == device), None)
        standing = self._stands.acting if unit is None else self._stands.with_device(unit)
        exchange = RobotExchange(self._composition, self._scenes, standing, self._offsets)
        return None if standing == self._stands.acting or exchange.is_ready else exchange

    def reset(self) -> None:
        """Everything back to its start, at rest; all drives hold. Time, claims and pressed buttons go on."""
        for unit in self._acting:
            self._feed(unit, DriveInput.RESET)
        self._press_again()
        mujoco.mj_resetData(self._plant.model, self._plant.data)
        for unit in self._present:
            unit.restart()
        self._sense_ns = self.now_ns
        self._begin()

    def places(self) -> tuple[Reason, ...]:
        """What stands where at the start."""
        return tuple(self._places().places(self._start))

    def displaced(self) -> tuple[Displacement, ...]:
        """What does not stand there now: what hands hold first, then parts, then robots, which may be anywhere."""
        return tuple(self._places().displaced(self._hands, self._forceless, self._present))

    def watch_mishaps(self) -> None:
        """From now on notice what no program means: arms that touch something, parts that fall."""
        self._lookout = CellLookout(self._composition.world, self._claimed_at, lambda: self.lit)
        self._begin()

    def take_mishaps(self) -> list[MishapEvent]:
        """What was noticed since the last call."""
        return [] if self._lookout is None else self._lookout.take()

    def standing(self) -> tuple[Reason, ...]:
        """In sentences what is worth knowing of how everything stands."""
        unstable = [Reason.of("workcell.unstable")] if self._is_unstable else []
        lamps = [(called(lamp.lamp.names, Reason.plain(lamp.lamp.name)), lamp.flags.all()) for lamp in self._lamps]
        lit = [Reason.of("workcell.named_lamp_lit", lamp=lamp) for lamp, is_lit in lamps if is_lit]
        dark = (lamp for lamp, is_lit in lamps if not is_lit)
        away = (displaced.text for displaced in self.displaced() if not displaced.is_harmless)
        return (*unstable, *lit, *(Reason.of("workcell.named_lamp_dark", lamp=name) for name in dark), *away)

    def scene(self) -> list[Shape3d]:
        """What there is to draw; changes when another robot stands at a place. Worked out once for each such change."""
        return self._scenes.of(self._stands.acting)

    def button_places(self) -> Mapping[str, Place]:
        """Where its panic buttons and touched switches stand, and on what."""
        places = button_places(self._composition.world, self._plant.model, self._plant.data)
        return {name: place for name, place in places.items() if name in self._buttons}

    @property
    def switches(self) -> tuple[str, ...]:
        """What a hand touches that stops nothing."""
        return tuple(switch.name for switch in self._composition.world.switches if switch.is_touched)

    @property
    def lit(self) -> tuple[str, ...]:
        """The shapes that shine."""
        return tuple(shape for lamp in self._lamps for shape in lamp.shining)

    def snapshot(self) -> bytes:
        """This instant for `onika.workcell.picture`."""
        drawn = self._scenes.drawing(self._stands.acting)
        glows = [(name, bool(lamp.flags.all())) for lamp in self._lamps for name in lamp.lamp.glows]
        lit, dark = ([name for name, shines in glows if shines is wanted] for wanted in (True, False))
        picture = still(drawn, self.poses(), self.lit, lit, dark)
        return encode(WorldSnapshot(picture, self.now_ns * 1e-9))

    def _compile(self, standing: Any, *, is_drawn: bool) -> mujoco.MjModel:
        return self._composition.compile(standing, self._offsets, is_drawn=is_drawn)

    def _model_with(self, place: str, robot: str) -> mujoco.MjModel:
        """The world's model with this robot at a place, the others as they stand first."""
        standing = self._composition.standing
        if standing[place] == robot:
            return self._plant.model
        return self._compile({**standing, place: robot}, is_drawn=False)

    def _more_units(self) -> Sequence[DeviceUnit]:
        """Devices of which only the class below this one knows."""
        return ()

    def _panic_buttons(self) -> Iterator[PanicButton]:
        for button in self._composition.world.buttons:
            units = self._stopped_by(button)
            if units:
                yield PanicButton(*units, name=button.name)

    def _stopped_by(self, button: ButtonBlock) -> list[RobotUnit]:
        return [unit for unit in self._stands.drives() if unit.side in button.stops and unit.is_stopped and unit.count]

    def _admit(self, unit: DeviceUnit) -> None:
        """Another robot may come to a place, or the world may lose its forces, or get them back."""
        if not isinstance(unit, RobotUnit) or unit in self._watching:
            return
        before, was_present = self._stands.mode, set(self._present)
        acting = dict(self._stands.acting)
        if not self._stands.admit(unit):
            return
        former = self._plant
        exchanged = {place for place, robot in acting.items() if robot != self._stands.acting[place]}
        if exchanged:
            self._plant = Plant(self._compile(self._stands.acting, is_drawn=False))
        self._bind()
        for newcomer in self._present:
            if newcomer not in was_present and (before == self._stands.mode or newcomer.side in exchanged):
                newcomer.restart()
        if former is not self._plant:
            self._plant.take(former, self._composition.names_of(exchanged, acting, self._stands.acting))
        for newcomer in self._present:
            if newcomer not in was_present and isinstance(newcomer, RobotUnit):
                newcomer.rest()
        self._press_again()
        self._begin()

    def _bind(self) -> None:
        self._robots = self._stands.present()
        parts, step_s = self._composition.parts, self.step_ns * 1e-9
        self._hands = CellHands(self._plant, self._robots, self._stands.arms(), parts, step_s)
        self._hindrance: CellHindrance | None = None
        for button in self._composition.world.buttons:
            if button.name in self._buttons:
                self._buttons[button.name].units = tuple(self._stopped_by(button))
        self._bind_units([*self._stands.drives(), *self._watching], [*self._robots, *self._watching])

    def _begin(self) -> None:
        """Go on from the plant's present positions: with physics, or without forces."""
        self._plant.vary(self._factors)
        self._plant.settle()
        self._feel = self._plant.sense
        self._running = self._runners()
        self._forceless = self._without_forces() if self._stands.mode else None
        if self._forceless is not None:
            self._plant.settle()
            self._feel = self._forceless.feel
        self._advance = self._stepping()
        if self._lookout is not None:
            self._advance = self._lookout.watch(
                self._plant, self._stands.arms(), self._hands.ways, self._advance, self._now, self._forceless
            )
        self._publish()

    def _halted(self, unit: DeviceUnit) -> tuple[Reason, tuple[Reason, ...]] | tuple[()]:
        """Where an arm stands that begins to hold, and what is in its way; nothing of what is no arm."""
        arms = self._stands.arms()
        if not isinstance(unit, JointUnit) or unit not in arms:
            return ()
        if self._hindrance is None:
            world, has_forces = self._composition.world, not self._stands.mode
            self._hindrance = CellHindrance(self._plant, world, arms, has_forces=has_forces)
        hindrance = self._hindrance
        return hindrance.place(unit), hindrance.told(unit, self._hands.held(unit, self._forceless))

    def _now(self) -> int:
        return self.now_ns

    def _claimed_at(self, place: str) -> tuple[str, ...]:
        """The devices at a place that somebody uses."""
        return tuple(unit.sheet.name for unit in self._present if unit.side == place and unit.epoch is not None)

    @property
    def _is_unstable(self) -> bool:
        """Whether physics had to begin anew, as something moved beyond all bounds."""
        return any(self._plant.data.warning[int(kind)].number for kind in _UNSTABLE)

    def _stepping(self) -> Callable[[Any, Any], None]:
        if self._forceless is not None:
            return self._forceless.step
        runs_on = any(isinstance(unit, RobotUnit) and unit.may_run_on for unit in self._present)
        return self._step if runs_on else mj_step

    def _without_forces(self) -> Forceless:
        parts = LooseParts(self._plant, self._composition.parts)
        return Forceless(self._plant, self._robots, parts, self._hands.ways, self.step_ns * 1e-9)

    def _places(self) -> CellPlaces:
        return CellPlaces(self._composition.world, self._plant, self._stands.arms())

    def _step(self, model: Any, data: Any) -> None:
        for unit in self._running:
            unit.run_on()
        mj_step(model, data)

    def _feed(self, unit: DeviceUnit, drive_input: DriveInput) -> None:
        super()._feed(unit, drive_input)
        self._running = self._runners()

    def _runners(self) -> list[RobotUnit]:
        return [unit for unit in self._present if isinstance(unit, RobotUnit) and unit.runs_on]


def _unlogged(_text: str) -> None:
    """What MuJoCo warns of counts in its data, and is told with how a world stands."""
