import msgspec

from onika.wire import act


def test_a_draft_is_asked_for_by_the_document():
    assert msgspec.to_builtins(act.Draft("c1")) == {"t": "Draft", "doc": "c1"}
