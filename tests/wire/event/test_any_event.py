import msgspec
import pytest

from onika.wire import event


def test_what_is_no_event_is_a_value_error():
    for body in (b"", b"\x80", b"\x81\xa4type\xa4Jump"):
        with pytest.raises(msgspec.DecodeError):
            event.decode(body)
