import pytest

from onika.host.recording.black_box_orders import CloseBlackBox, OpenBlackBox, RunOrder, decode_order, encode
from onika.host.recording.last_seconds import TracedEvent, TracedVariables
from onika.host.recording.recorded_variable import VariablePlace

ORDERS = (
    OpenBlackBox(1, "/a", 5, 6),
    TracedVariables("flow0", (VariablePlace("X", "double", "m", 64),)),
    TracedEvent("/events", 7, b"{}", "task a"),
    CloseBlackBox(1, True, {"cause": "x"}),
)


@pytest.mark.parametrize("order", ORDERS, ids=lambda order: type(order).__name__)
def test_orders_travel(order):  # law 29
    assert decode_order(encode(RunOrder(1, order))) == RunOrder(1, order)
