import math

from onika.record import topics
from onika.wire import event, live, request
from onika.wire.world_source import WorldFile, WorldSource
from onika.words.reason import Reason


def test_an_event_comes_back_as_it_was():  # R-X05
    message = topics.EventRecord("flow0", event.Began(0, 1, 3, "go", 1.25))
    assert topics.decode_happened(topics.encode(message)) == message


def test_a_request_comes_back_as_it_was():  # law 29
    for order in (
        request.Reply("flow0", "gauge", '0.5 "two"'),
        live.Touch("boxes", "panic", 1.0),
        live.Write("main", "Q", (0.5, 1.0)),
        request.Abort(Reason.plain("x")),
    ):
        message = topics.RequestRecord(2, "me", order)
        assert topics.decode_wanted(topics.encode(message)) == message


def test_what_json_does_not_know_is_written_all_the_same():
    failed = event.Failed("s", "t", Reason.plain("x"), "p", 1, "", 0.0, "cycle", {"X": math.nan, "Y": object})
    assert topics.decode_happened(topics.encode(topics.EventRecord("s", failed))).event.values["X"] is None


def test_topics_are_named_by_what_they_tell():
    assert topics.variable("flow0", "Q^_MEZ") == "/flow0/Q^_MEZ"
    assert (topics.frames("boxes"), topics.scene("boxes")) == ("/worlds/boxes/frames", "/worlds/boxes/scene")


def test_what_nobody_repeats_names_the_files_of_worlds_and_leaves_them_out():  # R-X19, law 29
    mesh = WorldFile("mesh.stl", "/robots/mesh.stl", bytes(1000))
    change = live.Change("main", on=(), worlds=(WorldSource("cell", "d1", (mesh,)),))
    assert topics.without_files(change).worlds == (WorldSource("cell", "d1", ()),)
    assert topics.without_files(change).subsystem == "main"
    for other in (live.Change("main", kill=("a",)), request.Abort(Reason.plain("x"))):
        assert topics.without_files(other) is other
