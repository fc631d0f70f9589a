"""Every message and every part of one: it travels whole, has a tag of its own, and says what it is."""

import pkgutil
from importlib import import_module
from typing import get_args

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from kit.wire.struct_values import values_of
from onika import wire
from onika.wire import act, event, packet, page, reading, request
from onika.wire.view.view import View

_JSON = ("onika.wire.act", "onika.wire.page", "onika.wire.view")
"""What a browser reads; all else is MessagePack."""

UNIONS = {
    "acts": get_args(act.AnyAct),
    "events": get_args(event.Event),
    "packets": get_args(packet.Packet),
    "page": get_args(page.AnyMessage),
    "readings": get_args(reading.Reading),
    "requests": get_args(request.Request),
    "responses": get_args(request.Response),
}
"""Messages that one decoder tells apart."""

CODECS = {
    "acts": (msgspec.json.encode, lambda body: msgspec.json.decode(body, type=act.AnyAct)),
    "events": (event.encode, event.decode),
    "packets": (packet.encode, packet.decode),
    "page": (page.encode, lambda body: msgspec.json.decode(body, type=page.AnyMessage)),
    "readings": (reading.encode, reading.decode),
    "requests": (request.encode, request.decode_request),
    "responses": (request.encode, request.decode_response),
}


def _structs():
    modules = [import_module(module.name) for module in pkgutil.walk_packages(wire.__path__, "onika.wire.")]
    classes = {value for module in modules for value in vars(module).values() if isinstance(value, type)}
    structs = {kind for kind in classes if issubclass(kind, msgspec.Struct)}
    return sorted((kind for kind in structs if kind.__module__.startswith("onika.wire")), key=str)


STRUCTS = _structs()
MESSAGES = [(room, kind) for room, union in UNIONS.items() for kind in union]
BASES = {kind for kind in STRUCTS if kind.__subclasses__()}
PARTS = sorted({*STRUCTS} - {kind for _, kind in MESSAGES} - BASES, key=str)
FEW = settings(max_examples=6, deadline=None, suppress_health_check=list(HealthCheck))


def _name(value):
    return value.__name__ if isinstance(value, type) else value


@pytest.mark.parametrize(("room", "kind"), MESSAGES, ids=_name)
@FEW
@given(data=st.data())
def test_a_message_travels_whole_through_its_codec(room, kind, data):  # R-F01
    encode, decode = CODECS[room]
    message = data.draw(values_of(kind))
    assert decode(encode(message)) == message


@pytest.mark.parametrize("kind", PARTS, ids=lambda kind: kind.__name__)
@FEW
@given(data=st.data())
def test_a_part_of_a_message_travels_whole(kind, data):  # R-F01
    codec = msgspec.json if kind.__module__.startswith(_JSON) else msgspec.msgpack
    part = data.draw(values_of(kind))
    assert codec.decode(codec.encode(part), type=kind) == part


@pytest.mark.parametrize("union", UNIONS.values(), ids=UNIONS)
def test_messages_of_one_decoder_have_tags_of_their_own(union):
    tags = [kind.__struct_config__.tag for kind in union]
    assert None not in tags
    assert len(set(tags)) == len(tags)


@pytest.mark.parametrize(
    ("room", "base"), [("acts", act.Act), ("page", page.Message)], ids=["acts", "messages to a page"]
)
def test_no_message_of_a_page_is_left_out(room, base):
    assert {kind for kind in STRUCTS if issubclass(kind, base)} - {base} == set(UNIONS[room])


def test_no_message_of_the_link_is_left_out():
    rooms = {
        *("steer", "live", "runtime_standing", "holding", "foresight", "samples", "rendezvous_link", "booking"),
        *("request", "event", "question", "reading", "packet"),
    }
    tagged = {kind for kind in STRUCTS if kind.__struct_config__.tag and kind.__module__.split(".")[2] in rooms}
    assert tagged == {kind for room, kind in MESSAGES if room not in ("acts", "page")}


@pytest.mark.parametrize("kind", STRUCTS, ids=lambda kind: kind.__name__)
def test_every_struct_says_what_it_is_and_cannot_be_changed(kind):
    assert vars(kind).get("__doc__")
    assert kind.__struct_config__.frozen


@pytest.mark.parametrize("kind", [*UNIONS["acts"], *UNIONS["packets"], page.Ordered], ids=lambda kind: kind.__name__)
def test_what_comes_from_outside_has_no_field_that_nobody_knows(kind):
    assert kind.__struct_config__.forbid_unknown_fields


def test_what_is_as_usual_does_not_travel_to_a_page():
    to_page = [kind for kind in STRUCTS if issubclass(kind, (act.Act, View, page.Message))]
    assert [kind for kind in to_page if not kind.__struct_config__.omit_defaults] == []


def test_nothing_is_confirmed_unless_it_is_said():  # R-X12
    defaults = [
        field.default for kind in STRUCTS for field in msgspec.structs.fields(kind) if field.name == "confirmed"
    ]
    assert len(defaults) > 5
    assert set(defaults) == {False}
