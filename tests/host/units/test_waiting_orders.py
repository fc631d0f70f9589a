import os
from threading import Event

from onika.host.units.waiting_orders import WaitingOrders


class Readied:
    """What is worked out in a copy, and taken over here once it may be."""

    def __init__(self):
        self.may_be_taken = Event()
        self.taken = b""
        self.whose = os.getpid()

    def work_out(self):
        return str(os.getpid() != self.whose).encode()

    def take(self, worked_out):
        self.may_be_taken.wait()
        self.taken = worked_out


def taken(waiting):
    """The next one, as soon as it is there."""
    while (order := waiting.take()) is None:
        pass
    return order


def test_orders_wait_in_their_order_until_the_work_for_the_first_is_done():  # law 16
    waiting, readied = WaitingOrders(), Readied()
    assert not waiting and waiting.take() is None
    waiting.begin(readied)
    waiting.put("claim")
    waiting.put("look")
    assert waiting and waiting.take() is None
    readied.may_be_taken.set()
    assert [taken(waiting), taken(waiting), waiting.take()] == ["claim", "look", None]
    assert readied.taken == b"True"


def test_what_cannot_be_worked_out_is_left_to_the_order_itself():  # law 16
    waiting, readied = WaitingOrders(), Readied()

    def fails():
        raise ValueError("expected a model, found none")

    readied.work_out = fails
    waiting.begin(readied)
    waiting.put("claim")
    assert taken(waiting) == "claim" and readied.taken == b""


def test_where_there_is_no_room_for_a_copy_the_order_does_it_itself(monkeypatch):  # law 16
    def refuses():
        raise BlockingIOError("no more processes")

    monkeypatch.setattr(os, "fork", refuses)
    waiting = WaitingOrders()
    waiting.begin(Readied())
    waiting.put("claim")
    assert waiting.take() == "claim"
