import msgspec

from onika.wire import act


def test_a_document_is_closed_by_its_id():
    assert msgspec.to_builtins(act.Close("c1", alive="leave")) == {"t": "Close", "doc": "c1", "alive": "leave"}
