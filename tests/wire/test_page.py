import msgspec
import pytest

from onika.wire import act, page, view

REMEDY = view.Remedy("Replace jtraj", act.Exchange("c1", "jtraj", "jvia"), view.ShowTask("jtraj"))
MESSAGES = (
    page.Snapshot(3, view.Tree(people=2), "1.0", "browser 1"),
    page.Patch(4, ((("documents", "c1"), None), (("people",), 3)), "browser 1"),
    page.Ok(7, 4, "c1"),
    page.Refused(8, "no", (REMEDY,), {"name": "expected a name"}),
    page.Frame(1.5, {"c1/Q": [0.5, None]}, {"c1/pd": {"cycle": 3}}, {"boxes": [0.0]}),
    page.Say("warning", "a word", "c1", view.ShowTask("pd"), 2.0),
)


@pytest.mark.parametrize("message", MESSAGES, ids=lambda message: type(message).__name__)
def test_a_message_travels_whole(message):
    assert msgspec.json.decode(page.encode(message), type=type(message)) == message


def test_every_message_is_tried():
    assert {type(message) for message in MESSAGES} == set(page.AnyMessage.__args__)


@pytest.mark.parametrize("body", [b"", b"{}", b"null", b'{"cid":"x","act":{"t":"New"}}', b'{"cid":1,"act":{}}'])
def test_what_is_no_act_is_a_value_error(body):
    with pytest.raises(ValueError):
        page.decode(body)
