from typing import get_args

from msgspec import Struct

from onika.engine import orders


def test_every_order_is_a_frozen_value_that_says_what_it_is_for():
    for order in get_args(orders.Order):
        assert issubclass(order, Struct)
        assert order.__struct_config__.frozen
        assert order.__doc__
        assert not order.__doc__.startswith(order.__name__ + "(")


def test_orders_with_the_same_content_are_equal():
    assert orders.Switch(0, ("a",), (orders.Launch("b", "1"),)) == orders.Switch(0, ("a",), (orders.Launch("b", "1"),))
    assert orders.Switch(0, (), ()) != orders.Switch(1, (), ())
