from onika.desk.environment.outcome.outcome import Ask, AwaitedNews, EditEnd, Order, RequiredRuntime
from onika.desk.environment.state.model import Model
from onika.wire import live


def test_an_order_asks_only_where_a_runtime_is_there_unless_it_says_which():  # R-C18
    assert Order(live.Survey()).reach is None
    assert RequiredRuntime() == RequiredRuntime("", "")


def test_an_order_is_itself_alone_so_that_a_reply_finds_who_waits_for_it():
    assert Order(live.Survey()) != Order(live.Survey())


def test_what_an_act_waits_for_carries_the_model_that_is_shown_meanwhile():
    model = Model(people=2)
    waits = (Ask(model, live.Survey()), AwaitedNews(model, EditEnd(7)))
    assert [wait.model.people for wait in waits] == [2, 2]
    assert waits[1].what == EditEnd(7) != EditEnd(8)
