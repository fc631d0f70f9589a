"""What a world consists of, asked once by whoever draws it; its poses follow with the frames."""

from onika.desk.environment.outcome.outcome import Done, No, Order
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.model import Model
from onika.wire import act, live, request


def scene(model: Model, asked: act.Scene, _outside: Surroundings) -> Done | No:
    """Ask what a world consists of."""
    return Done(model, orders=(Order(live.Scene(asked.world), _told),), is_answered_later=True)


def _told(model: Model, response: request.Response) -> Done | No:
    if isinstance(response, live.Scenery):
        return Done(model, value=response.scene)
    return No(refusal(response))
