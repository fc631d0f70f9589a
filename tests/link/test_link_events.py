from onika.link.link_events import Failed, Fate, Happening, Signalled, Turned
from onika.link.state import LinkState


def test_equal_happenings_are_equal_values():
    assert Signalled(1, b"x") == Signalled(1, b"x") != Signalled(2, b"x")
    assert Turned(LinkState.LINKED) == Turned(LinkState.LINKED, None)
    assert isinstance(Failed(1, Fate.LOST), Happening)


def test_each_fate_says_whether_something_may_have_been_carried_out():
    assert [fate for fate in Fate if "nothing was carried out" in fate.value] == [Fate.UNSENT, Fate.LATE]
    assert "may or may not" in Fate.LOST.value
