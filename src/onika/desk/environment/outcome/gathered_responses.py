"""Responses of several runtimes to what was asked of all of them at one time, until the last has come."""

from onika.desk.environment.outcome.outcome import AskAll, Order
from onika.wire.request import Response


class GatheredResponses:
    """Of every question to several runtimes, what has come so far."""

    def __init__(self) -> None:
        self._places: dict[object, tuple[AskAll, int]] = {}
        self._responses: dict[AskAll, dict[int, Response]] = {}

    def begin(self, question: AskAll) -> tuple[Order, ...]:
        """The orders of a question, whose responses are gathered from now on."""
        orders = tuple(Order(request, station=station) for station, request in question.requests)
        self._places |= {order.identity: (question, place) for place, order in enumerate(orders)}
        self._responses[question] = {}
        return orders

    def take(self, order: Order, response: Response) -> tuple[AskAll, tuple[Response, ...]] | None:
        """The question and all its responses, where this was the last; None: it is not, or was asked alone."""
        if order.identity not in self._places:
            return None
        question, place = self._places.pop(order.identity)
        responses = self._responses[question]
        responses[place] = response
        if len(responses) < len(question.requests):
            return None
        del self._responses[question]
        return question, tuple(responses[at] for at in range(len(responses)))
