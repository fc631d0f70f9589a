"""News as datagrams."""

import numpy as np
import pytest

from onika.runtime import news
from onika.runtime.load import TaskLoad
from onika.runtime.user_input import AskedItem
from onika.words.reason import Reason

ITEM = AskedItem("endpoint", "double", 2, "rad", "where to", (0.0, 0.0), (-1.0, -2.0), None)
STATUS = news.TaskStatus("s", "t", "m", "ON", "periodic", 0, 5, 1, 0, 100.0, 99.0, 1.0, 10.0, 1.0, 2.0, 4.0)
NEWS = [
    news.Initialised("s", "t"),
    news.Reinitialised("s", "t"),
    news.Rebound("s", "t"),
    news.Swapped("s", "t", "0123abcd"),
    news.Changed("s", "t", "ON", 5),
    news.Changed("s", "t", "ON", 5, activation=3),
    news.Changed("s", "t", "OFF", 5, "OFF"),
    news.Cycled("s", "t", 5),
    news.Finished("s", "t", 1, True, 5),
    news.Failed("s", "t", "cycle", Reason.plain("ValueError: x"), "m.py", 3, "trace", 5),
    news.Failed("s", "t", "cycle", Reason.plain("x"), "m.py", 3, "trace", 5, 2, {"Q": [1.0, 2.0], "NAME": "cube"}),
    news.Warned("s", "t", Reason.plain("slow"), 5),
    news.Finished("s", "t", 1, True, 5, 7, 2),
    news.Unprepared("s"),
    news.Signalled("s", "t", "ILLEGAL", 0, Reason.plain("door open"), 5),
    news.Stepped("s", "t", "TAU_REF", "N m", 1, 30.0, 10.0, 18.64, 4, 5),
    news.Asked("s", "t", Reason.plain("too far"), (ITEM,), 5),
    news.Refused("s", "t", "on", Reason.plain("no such task")),
    news.Got("s", "t", "progress", 0.5),
    news.Statuses("control", 0.25, (STATUS,)),
    news.Appointed(4, 9_000, True),
    news.HeldAlone(4, 9_000),
    news.Loads("control", (TaskLoad("s", "t", True, 100.0, 5.0, 9.0, 3),)),
]


@pytest.mark.parametrize("event", NEWS, ids=lambda event: type(event).__name__)
def test_news_arrive_as_they_were_sent(event):
    assert news.decode(news.encode(event)) == event


def test_every_piece_of_news_is_among_these():
    assert {type(event) for event in NEWS} == set(news.News.__args__)


@pytest.mark.parametrize(
    ("value", "arrives"),
    [
        (np.array([[1.0, 2.0]]), [[1.0, 2.0]]),
        (np.float64(0.5), 0.5),
        (np.int32(3), 3),
        (np.bool_(True), True),
        (1 + 2j, "(1+2j)"),
        ({"q": np.zeros(2)}, {"q": [0.0, 0.0]}),
    ],
)
def test_whatever_a_module_hands_out_travels_as_plain_values(value, arrives):  # R-A05
    assert news.decode(news.encode(news.Got("s", "t", "name", value))).value == arrives
