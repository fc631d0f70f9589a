from onika.engine.rendezvous_orders import AllMet, Alone, Appoint


def test_orders_are_values():
    assert Appoint(1, 5) == Appoint(1, 5) != Appoint(2, 5)
    assert (AllMet().is_free, Alone((2,)).absent) == (False, (2,))
