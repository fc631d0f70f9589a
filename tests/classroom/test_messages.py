import pytest

from onika.classroom import messages
from onika.wire.view import ClassSeatView
from onika.words.reason import Reason

ORDERS = [
    messages.Admit("k", is_teacher=True),
    messages.ShutOut(),
    messages.ShowSeat(ClassSeatView(3, "Ana", "frozen", "look up", 2)),
    messages.Collect(),
    messages.LeaveClass(),
]
NEWS = [
    messages.Opened(),
    messages.SeatStanding(pages=1, program="go_home", refusal=Reason.of("class.act_closed"), refusal_s=2.5),
    messages.HandedIn("handed-in/0001"),
]


@pytest.mark.parametrize("order", ORDERS, ids=lambda order: type(order).__name__)
def test_an_order_is_a_line_and_is_read_again(order):  # R-X25
    line = messages.line(order)
    assert line.endswith(b"\n")
    assert line.count(b"\n") == 1
    assert messages.order(line) == order


@pytest.mark.parametrize("news", NEWS, ids=lambda news: type(news).__name__)
def test_news_are_a_line_and_are_read_again(news):
    assert messages.news(messages.line(news)) == news


@pytest.mark.parametrize("line", [b"", b"{}", b"[1]", b'{"t":"LeaveClass"}', b'{"t":"HandedIn","folder":3}', b"\xff"])
def test_a_seat_is_believed_nothing_else(line):
    with pytest.raises(ValueError):
        messages.news(line)
