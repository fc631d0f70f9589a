"""Which lamps and sensors of a world of files can be used; the others are told with their lines (requirement X19)."""

from collections.abc import Iterator, Mapping, Set
from typing import Any

from onika.model.world import LampBlock, WorldText
from onika.words.fault import Fault, Place
from onika.words.reason import Reason
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.robot_model import robot_spec
from onika.workcell.composed.sensor_unit import SensorUnit, lacking
from onika.workcell.composed.switch_lamp import SwitchLamp, lacking_contact
from onika.workcell.composed.usable_parts import part_spec, prefix_of
from onika.workcell.panic_button import PanicButton

_MOST_LISTED = 20


def touched_switches(world: WorldText) -> dict[str, PanicButton]:
    """The switches that a hand can touch, by their names."""
    return {switch.name: PanicButton(name=switch.name) for switch in world.switches if switch.is_touched}


def usable_lamps(composition: Composition, model: Any, touched: Mapping[str, PanicButton]) -> Iterator[SwitchLamp]:
    """The lamps whose switches have all that they name."""
    world = composition.world
    switches = {}
    for switch in world.switches:
        unfit = lacking_contact(model, switch)
        if unfit is None:
            switches[switch.name] = switch
            continue
        line, because = switch.lines.get(unfit.keyword, 0), composition.lost(*switch.elements)
        composition.leave_out(switch.name, line, unfit.reason, because)
    for lamp in world.lamps:
        gone = [name for name in lamp.when if name not in switches]
        if gone:
            reason, line = Reason.of("workcell.switch_left_out", name=gone[0]), lamp.lines.get("WHEN", 0)
            composition.leave_out(lamp.name, line, reason, composition.lost(*gone))
        else:
            _tell_dark(composition, lamp)
            yield SwitchLamp(lamp, switches, touched)


def _tell_dark(composition: Composition, lamp: LampBlock) -> None:
    """Tell of names behind a lamp that are those of no shape, unless it is told why they are gone."""
    for keyword, names in (("SHINES", lamp.shines), ("GLOWS", lamp.glows)):
        there = _shape_names(composition) if names else set()
        for name in names:
            if name not in there and not composition.lost(name):
                place = Place(composition.sources.place.file, lamp.lines.get(keyword, 0))
                reason = Reason.of("workcell.no_such_name", there=_listed(there), name=name)
                composition.faults.append(Fault(place, reason, Reason.of("workcell.shape_dark", name=lamp.name)))


def _shape_names(composition: Composition) -> set[str]:
    """The names of all shapes that a world may have, whichever robots stand at its places."""
    sources = composition.sources
    of_parts = [(prefix_of(part.name), part_spec(sources, part)) for part in composition.parts]
    of_robots = [
        (prefix_of(place.name), robot_spec(sources, composition.robot(place, name).robot))
        for place in composition.places for name in composition.at(place)
    ]  # fmt: skip
    return {prefix + geom.name for prefix, spec in (*of_parts, *of_robots) for geom in spec.geoms if geom.name}


def _listed(names: Set[str]) -> Reason | tuple[str, ...]:
    return tuple(sorted(names))[:_MOST_LISTED] or Reason.of("workcell.none")


def usable_sensors(composition: Composition, model: Any) -> Iterator[SensorUnit]:
    """What is measured in the world itself."""
    for sensor in composition.world.sensors:
        unfit = lacking(model, sensor)
        if unfit is None:
            yield SensorUnit(sensor.name, sensor, model, "", "", "")
        else:
            line, because = sensor.lines.get(unfit.keyword, 0), composition.lost(sensor.body, *sensor.reads)
            composition.leave_out(sensor.name, line, unfit.reason, because)
