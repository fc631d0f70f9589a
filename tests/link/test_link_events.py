from onika.link.link_events import LinkNotice, LinkStateChanged, RequestFailed, RequestFate, SignalReceived
from onika.link.state import LinkState


def test_equal_notices_are_equal_values():
    assert SignalReceived(1, b"x") == SignalReceived(1, b"x") != SignalReceived(2, b"x")
    assert LinkStateChanged(LinkState.LINKED) == LinkStateChanged(LinkState.LINKED, None)
    assert isinstance(RequestFailed(1, RequestFate.LOST), LinkNotice)


def test_each_fate_says_whether_something_may_have_been_carried_out():
    assert [fate for fate in RequestFate if "nothing was carried out" in str(fate.reason)] == [
        RequestFate.UNSENT,
        RequestFate.LATE,
        RequestFate.TOO_LONG,
    ]
    assert "may or may not" in str(RequestFate.LOST.reason)
