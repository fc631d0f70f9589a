from onika.desk.environment.outcome.outcome import Done, No, Order, Reach
from onika.desk.environment.state.model import Model
from onika.wire import live


def test_an_order_asks_only_where_a_runtime_is_there_unless_it_says_which():  # R-C18
    assert Order(live.Survey()).reach is None
    assert Reach() == Reach("", "")


def test_a_refusal_changes_nothing_unless_something_was_done_already():  # R-X10
    model = Model()
    assert No("no").instead is None
    assert No("no", instead=Done(model)).instead == Done(model)
