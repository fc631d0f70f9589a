"""What a world consists of, asked once by whoever draws it; its poses follow with the frames."""

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.pressed_parts import with_pressed
from onika.desk.environment.reconcile.watches import world_at
from onika.desk.environment.state.model import Model
from onika.wire import act, live


def scene(model: Model, command: act.Scene, _outside: Services) -> Procedure:
    """Ask what a world consists of."""
    world = world_at(model.station, command.world)
    model, response = yield Ask(model, live.Scene(world))
    if isinstance(response, live.Scenery):
        pressed = response.scene.get("pressed", ())
        return Done(with_pressed(model, world, pressed), value=response.scene)
    return No(refusal(response))
