from onika.desk.environment.outcome.outcome import Order
from onika.desk.environment.replay.recorded_runtime import RecordedRuntime
from onika.wire import live, request


def test_a_reply_is_that_to_the_oldest_order_of_its_kind_and_station():  # R-H08
    runtime = RecordedRuntime()
    first, second = Order(live.Survey()), Order(live.Survey(), station="")
    elsewhere, other = Order(live.Survey(), station="b"), Order(request.Snapshot())
    for order in (other, elsewhere, first, second):
        runtime.send(order)
    assert runtime.awaiting("", "Survey") is first
    assert runtime.awaiting("", "Survey") is second
    assert runtime.awaiting("", "Survey") is None
    assert runtime.awaiting("b", "Survey") is elsewhere
