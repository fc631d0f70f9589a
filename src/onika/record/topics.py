"""The topics of a recording beside its variables: events, requests, worlds."""

from typing import Any

import msgspec
from msgspec import Struct, structs

from onika.record.bare_text import decoder
from onika.wire import event, live, request, steer
from onika.wire.world_source import WorldSource

EVENTS, COMMANDS, ANSWERS = "/events", "/commands", "/answers"

STEERING = (
    steer.Pause,
    steer.Resume,
    steer.Step,
    steer.Skip,
    steer.Pass,
    steer.Leave,
    steer.Mark,
    steer.Recover,
    request.Reply,
    request.Abort,
    request.Stop,
    live.Reset,
    live.Touch,
    live.PutBack,
    live.Change,
    live.Set,
    live.Write,
    live.Push,
    live.Reinit,
    live.Swap,
    live.Clear,
    live.Close,
    live.AddUnit,
)
"""What may change the course of a run."""


def variable(subsystem: str, name: str) -> str:
    """The topic of a variable."""
    return f"/{subsystem}/{name}"


def frames(world: str) -> str:
    """The topic of where the bodies of a world are."""
    return f"/worlds/{world}/frames"


def scene(world: str) -> str:
    """The topic of what a world consists of."""
    return f"/worlds/{world}/scene"


def shapes(world: str) -> str:
    """The name of the file in which the shapes of a world stand as they were shown, with names and paints."""
    return f"worlds/{world}.json"


class EventRecord(Struct, frozen=True):
    """An event; `subsystem` is whom it is about, empty: everybody."""

    subsystem: str
    event: event.Event


class RequestRecord(Struct, frozen=True):
    """A request that may change the course of the run: after so many turns of the clock at its instant."""

    turn: int
    session: str
    request: request.Request


def without_files(message: request.Request) -> request.Request:
    """A request that nobody repeats: worlds without their files, which are as large as their meshes, only named."""
    if not isinstance(message, live.Change) or not message.worlds:
        return message
    worlds = tuple(WorldSource(source.world, source.digest, ()) for source in message.worlds)
    return structs.replace(message, worlds=worlds)


def _schema(title: str, **properties: Any) -> bytes:
    return msgspec.json.encode({"title": title, "type": "object", "properties": properties})


_TEXT = {"type": "string"}
_MESSAGE = {"type": "object", "properties": {"type": _TEXT}}
HAPPENED, WANTED = "onika.Event", "onika.Request"
HAPPENED_SCHEMA = _schema(HAPPENED, subsystem=_TEXT, event=_MESSAGE)
WANTED_SCHEMA = _schema(WANTED, turn={"type": "integer"}, session=_TEXT, request=_MESSAGE)

encode = msgspec.json.Encoder(enc_hook=str).encode
decode_happened = decoder(EventRecord)
decode_wanted = decoder(RequestRecord)
