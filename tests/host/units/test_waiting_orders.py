from threading import Event

from onika.host.units.waiting_orders import WaitingOrders


def taken(waiting):
    """The next one, as soon as it is there."""
    while (order := waiting.take()) is None:
        pass
    return order


def test_orders_wait_in_their_order_until_the_work_for_the_first_is_done():  # law 16
    waiting, done = WaitingOrders(), Event()
    assert not waiting and waiting.take() is None
    waiting.begin(done.wait)
    waiting.put("claim")
    waiting.put("look")
    assert waiting and waiting.take() is None
    done.set()
    assert [taken(waiting), taken(waiting), waiting.take()] == ["claim", "look", None]


def test_what_cannot_be_worked_out_is_left_to_the_order_itself():  # law 16
    waiting = WaitingOrders()

    def fails():
        raise ValueError("expected a model, found none")

    waiting.begin(fails)
    waiting.put("claim")
    assert taken(waiting) == "claim"
