"""A hand presses parts of a simulated workcell, such as a panic button, and lets them go (§4.5.2)."""

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.pressed_parts import with_pressed
from onika.desk.environment.reconcile.watches import world_at
from onika.desk.environment.state.model import Model
from onika.wire import act, live, request
from onika.words.reason import Reason


def touch(model: Model, command: act.Touch, _outside: Services) -> No | Procedure:
    """Ask for it at once, whatever else is under way; refused where nothing is open, and in a real world."""
    world = world_at(model.station, command.world)
    if model.runtime.state != "linked" or world not in model.runtime.worlds:
        return No(Reason.of("run.touch_not_open", world=command.world))
    if model.runtime.world_kinds.get(world) == "real":
        return No(Reason.of("run.touch_real", world=command.world, part=command.part))
    return _touched(model, world, command)


def _touched(model: Model, world: str, command: act.Touch) -> Procedure:
    model, response = yield Ask(model, live.Touch(world, command.part, 1.0 if command.is_pressed else 0.0))
    if not isinstance(response, request.Done):
        return No(refusal(response))
    held = {part for part in model.runtime.pressed.get(world, ()) if part != command.part}
    return Done(with_pressed(model, world, held | {command.part} if command.is_pressed else held))
