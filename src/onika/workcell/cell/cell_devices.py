"""Which lamps and sensors of a world of files can be used; the others are told with their lines (requirement X19)."""

from collections.abc import Iterator, Mapping
from typing import Any

from onika.model.world import WorldText
from onika.words.reason import Reason
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sensor_unit import SensorUnit, lacking
from onika.workcell.composed.switch_lamp import SwitchLamp, lacking_contact
from onika.workcell.panic_button import PanicButton


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
            yield SwitchLamp(lamp, switches, touched)


def usable_sensors(composition: Composition, model: Any) -> Iterator[SensorUnit]:
    """What is measured in the world itself."""
    for sensor in composition.world.sensors:
        unfit = lacking(model, sensor)
        if unfit is None:
            yield SensorUnit(sensor.name, sensor, model, "", "", "")
        else:
            line, because = sensor.lines.get(unfit.keyword, 0), composition.lost(sensor.body, *sensor.reads)
            composition.leave_out(sensor.name, line, unfit.reason, because)
