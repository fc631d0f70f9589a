"""What a world consists of, asked once by whoever draws it; its poses follow with the frames."""

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.watches import world_at
from onika.desk.environment.state.model import Model
from onika.wire import act, live


def scene(model: Model, command: act.Scene, _outside: Services) -> Procedure:
    """Ask what a world consists of."""
    model, response = yield Ask(model, live.Scene(world_at(model.station, command.world)))
    if isinstance(response, live.Scenery):
        return Done(model, value=response.scene)
    return No(refusal(response))
