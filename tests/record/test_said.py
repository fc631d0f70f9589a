import math

from onika.record import said
from onika.wire import event, live, request


def test_an_event_comes_back_as_it_was():  # R-X05
    one = said.Happened("flow0", event.Began(0, 1, 3, "go", 1.25))
    assert said.decode_happened(said.encode(one)) == one


def test_a_request_comes_back_as_it_was():  # law 29
    for asked in (request.Reply("flow0", "gauge", '0.5 "two"'), live.Touch("boxes", "panic", 1.0), request.Abort("x")):
        one = said.Wanted(2, "me", asked)
        assert said.decode_wanted(said.encode(one)) == one


def test_what_json_does_not_know_is_written_all_the_same():
    failed = event.Failed("s", "t", "x", "p", 1, "", 0.0, "cycle", {"X": math.nan, "Y": object})
    assert said.decode_happened(said.encode(said.Happened("s", failed))).event.values["X"] is None


def test_topics_are_named_by_what_they_tell():
    assert said.variable("flow0", "Q^_MEZ") == "/flow0/Q^_MEZ"
    assert (said.frames("boxes"), said.scene("boxes")) == ("/worlds/boxes/frames", "/worlds/boxes/scene")
