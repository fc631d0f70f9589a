import pytest

from onika.host.sessions.request_decoder import decode
from onika.wire import holding, live, request, steer

PAUSED = request.Recorded(10, 0, request.encode(steer.Pause()))


@pytest.mark.parametrize(
    "message",
    [
        request.Begin(watch=("X",), repeat=(PAUSED,), repeat_until_ns=-1),
        live.Take("main"),
        live.Attend(("*",), ("main/*",)),
        live.Touch("boxes", "panic", 1.0),
    ],
)
def test_an_honest_request_is_itself(message):  # R-F01
    assert decode(request.encode(message)) == message


@pytest.mark.parametrize(
    "body", [b"", b"\xff", b"\x91" * 100_000, request.encode({"type": "Nothing"}), request.encode(live.Take("a"))[:-1]]
)
def test_bytes_that_are_no_request_are_refused(body):  # R-F01
    with pytest.raises(ValueError) as refused:
        decode(body)
    assert refused.value.args[0].key in ("host.no_request", "host.request_deep")


@pytest.mark.parametrize(
    ("message", "key"),
    [
        (live.Take("a\0b"), "host.name_form"),
        (live.Change("x" * 5000), "host.name_form"),
        (live.Touch("boxes", "panic", float("nan")), "host.number_infinite"),
        (live.Advance(float("inf")), "host.seconds_range"),
        (steer.Onward(until_s=float("inf")), "host.number_infinite"),
        (steer.Onward(until_s=float("nan")), "host.number_infinite"),
        (live.Attend(("*",) * 2000), "host.too_many_watched"),
        (request.Begin(on_loss="dance"), "host.word_unknown"),
        (request.Begin(on_error="dance"), "host.word_unknown"),
        (request.Begin(settle_s=float("inf")), "host.seconds_range"),
        (request.Begin(repeat_until_ns=-5), "host.number_infinite"),
        (request.Begin(record="a\0"), "host.text_form"),
        (holding.Listen("127.0.0.1:7994", certificate="a\0b"), "host.text_form"),
        (holding.Listen("127.0.0.1:7994", names=("x" * 5000,)), "host.text_form"),
        (request.Begin(repeat=(request.Recorded(-1, 0, PAUSED.body),)), "host.number_infinite"),
        (request.Begin(repeat=(request.Recorded(1, 0, b"\xc1"),)), "host.not_repeated"),
        (request.Begin(repeat=(request.Recorded(1, 0, request.encode(request.Quit())),)), "host.not_repeated"),
        (request.Begin(repeat=(request.Recorded(1, 0, request.encode(request.Begin())),)), "host.not_repeated"),
    ],
)  # R-F01
def test_a_request_that_means_nothing_is_refused_with_its_reason(message, key):
    with pytest.raises(ValueError) as refused:
        decode(request.encode(message))
    assert refused.value.args[0].args["why"].key == key


@pytest.mark.parametrize("number", [2**64 - 1, 2**31, -2])
def test_a_number_that_no_action_can_have_is_refused(number):  # R-F01: its successor could not even be told
    with pytest.raises(ValueError, match="int"):
        decode(request.encode(steer.Mark("flow0", number)))
