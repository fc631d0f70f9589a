from contextlib import suppress

import numpy as np
import pytest
from hypothesis import given, strategies as st
from msgspec import MsgspecError, msgpack

from onika.model.signal import finish, illegal, legal, off, user_signal
from onika.runtime.command import DeviceGrant
from onika.runtime.sandbox.sandbox_messages import (
    Bind,
    Call,
    Returned,
    decode_answer,
    decode_order,
    device_sizes,
    encode,
    signal_of_row,
    signal_row,
)
from onika.words.reason import Reason

VALUES = st.one_of(st.integers(-(2**63), 2**63 - 1), st.floats(allow_nan=False), st.text(max_size=20), st.booleans())


@given(VALUES, st.floats(0, 1e6))
def test_a_call_comes_back_as_it_was(value, now):
    call = Call("on", now, 0.01, 3, ({"x": value},), frozenset(("Q",)))
    assert decode_order(encode(call)) == call


@pytest.mark.parametrize("dtype", ["float64", "int32", "uint8", "bool"])
def test_an_array_keeps_its_shape_and_type_and_may_be_written(dtype):
    array = np.arange(6).reshape(2, 3).astype(dtype)
    value = decode_answer(encode(Returned(array))).value
    assert value.dtype == array.dtype
    assert np.array_equal(value, array)
    value[0, 0] = 1


@pytest.mark.parametrize("signal", [finish(2, loop=True), off(), illegal("too far"), legal(), user_signal(18)])
def test_a_signal_comes_back_as_it_was(signal):
    assert signal_of_row(decode_answer(encode(Returned(signal=signal_row(signal)))).signal) == signal


def test_a_signal_of_no_kind_is_refused():
    with pytest.raises(ValueError, match="JUMP"):
        signal_of_row(("JUMP", 0, False, 0, Reason("", "")))


@pytest.mark.parametrize(
    "body", [b"|O 1\n12345678", b"<f8 9\n12345678", b"\xff", b"<f8", b"<M8[ns] 1\n12345678"]
)  # R-X16
def test_an_array_that_is_none_is_refused(body):
    answer = msgpack.encode({"type": "Returned", "value": msgpack.Ext(1, body)})
    with pytest.raises((MsgspecError, ValueError, TypeError)):
        decode_answer(answer)


@given(st.binary(max_size=200))
def test_of_any_bytes_either_a_message_comes_or_a_refusal(body):  # R-X16
    for decode in (decode_order, decode_answer):
        with suppress(MsgspecError, ValueError, TypeError, KeyError):
            decode(body)


def test_what_cannot_be_sent_is_said():
    with pytest.raises(TypeError, match="found object"):
        encode(Bind((), {"x": object()}))


def test_the_room_for_a_device_is_that_of_what_it_says_and_is_told():
    grant = DeviceGrant("bus", "arm", ("t", "d", "q"), ("tau",), {}, 1, 0, 0, (4, 8))
    assert device_sizes(grant) == (24, 24, 96)
    assert device_sizes(None) == (0, 0, 0)
