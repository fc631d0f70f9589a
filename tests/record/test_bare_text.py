from typing import get_args

import msgspec
import pytest
from msgspec import Struct, inspect

from onika.record import topics
from onika.record.bare_text import decoder
from onika.wire import event
from onika.words.reason import Reason


class Told(Struct, frozen=True):
    reason: Reason
    others: tuple[Reason, ...] = ()
    by_name: dict[str, Reason] = {}
    perhaps: Reason | None = None
    name: str = ""


READ = decoder(Told)


def test_reasons_are_read_as_they_are():
    texts = Told(Reason.of("words.nothing_run"), (Reason.plain("a"),), {"x": Reason.plain("b")}, Reason.plain("c"), "d")
    assert READ(msgspec.json.encode(texts)) == texts


def test_bare_texts_in_the_place_of_reasons_are_reasons_without_a_key():  # R-X05
    body = b'{"reason":"gone","others":["a",{"key":"plain","text":"b"}],"by_name":{"x":"c"},"perhaps":"d","name":"e"}'
    plain = Reason.plain
    assert READ(body) == Told(plain("gone"), (plain("a"), plain("b")), {"x": plain("c")}, plain("d"), "e")


@pytest.mark.parametrize("body", [b'{"reason":1}', b"{}", b"[]", b"", b'{"reason":"a","name":3}', b"[" * 5000])
def test_what_is_neither_is_refused(body):
    with pytest.raises((msgspec.MsgspecError, RecursionError)):
        READ(body)


@pytest.mark.parametrize("kind", get_args(event.Event), ids=lambda kind: kind.__name__)
def test_every_event_of_a_former_recording_is_read(kind):  # R-X05
    fields = {field.encode_name: _former(field.type) for field in inspect.type_info(kind).fields if field.required}
    body = msgspec.json.encode({"subsystem": "main", "event": {"type": kind.__name__} | fields})
    assert isinstance(topics.decode_happened(body).event, kind)


def _former(kind):
    """A value as version 0.1.0 wrote it: a text for every reason."""
    match kind:
        case inspect.StructType() if kind.cls is Reason:
            return "said"
        case inspect.StrType():
            return "text"
        case inspect.BytesType():
            return ""
        case inspect.BoolType():
            return True
        case inspect.IntType() | inspect.FloatType():
            return 1
        case inspect.UnionType():
            return _former(kind.types[0])
        case inspect.TupleType():
            return [_former(item) for item in kind.item_types]
        case inspect.VarTupleType() | inspect.ListType():
            return []
        case inspect.DictType():
            return {}
        case inspect.StructType():
            return {field.encode_name: _former(field.type) for field in kind.fields if field.required}
    return None
