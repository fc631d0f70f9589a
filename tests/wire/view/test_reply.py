import msgspec

from onika.wire import view


def test_a_text_that_may_be_edited_says_no_more():
    assert msgspec.to_builtins(view.TextView("a.rmod", "x", "1")) == {"path": "a.rmod", "text": "x", "stamp": "1"}
