from onika.desk.environment.run_state.question import ask_view
from onika.wire import event
from onika.words.reason import Reason

ITEM = event.Item("goal", "double", 2, "rad", "where to", None, (-1.0, -2.0), (1.0, 2.0))


def test_a_question_is_shown_with_its_ranges_and_with_where_the_robot_stands():  # R-C13, R-K07
    question = event.Asked("flow0", "servo", Reason.plain("9 is too far"), (ITEM,), 0.5)
    view = ask_view(question, {"goal": [0.1, 0.2]})
    (item,) = view.items
    assert (item.name, item.count, item.unit, item.low, item.high) == ("goal", 2, "rad", (-1.0, -2.0), (1.0, 2.0))
    assert (str(view.reason), view.present) == ("9 is too far", {"goal": (0.1, 0.2)})
    assert ask_view(question).present == {}
