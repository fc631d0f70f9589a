"""Which lamps and sensors of a world of files can be used; the others are told with their lines (requirement X19)."""

from collections.abc import Iterator
from typing import Any

from onika.words.reason import Reason
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sensor_unit import SensorUnit, lacking
from onika.workcell.composed.switch_lamp import SwitchLamp, lacking_contact


def usable_lamps(composition: Composition, model: Any) -> Iterator[SwitchLamp]:
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
            yield SwitchLamp(lamp, switches)


def usable_sensors(composition: Composition, model: Any) -> Iterator[SensorUnit]:
    """What is measured in the world itself."""
    for sensor in composition.world.sensors:
        unfit = lacking(model, sensor)
        if unfit is None:
            yield SensorUnit(sensor.name, sensor, model, "", "", "")
        else:
            line, because = sensor.lines.get(unfit.keyword, 0), composition.lost(sensor.body, *sensor.reads)
            composition.leave_out(sensor.name, line, unfit.reason, because)
