"""The packets of the link: what its two ends say to each other; what environment and runtime say travels inside.

Greeting  Hello → Welcome (or Bye). Nothing else is said on a new connection before these.
Session   Request → Reply, begun by the environment; a long body goes ahead in Parts.
Signal    Signal → Ack, begun by the runtime. Beat both ways.
Stream    Reading, from the runtime: newest wins.
"""

from typing import Annotated, Literal

import msgspec

from onika.words.reason import Reason

VERSION = 3
"""Version of this language; two ends of different versions do not talk."""

Count = Annotated[int, msgspec.Meta(ge=0, le=2**63 - 1)]
"""A number of something: requests, signals and beats count from 1; 0 means none yet."""

Name = Annotated[str, msgspec.Meta(max_length=128)]
"""Who: a client, an epoch, the key of a reading."""

Sentence = Annotated[str, msgspec.Meta(max_length=1000)]
"""Words for people."""


class Hello(msgspec.Struct, frozen=True, array_like=True, tag="hello", forbid_unknown_fields=True):
    """The environment's first words: who it is and the last signal of which epoch it has ("" and 0: none)."""

    version: Count
    client: Name
    epoch: Name
    seq: Count


class Welcome(msgspec.Struct, frozen=True, array_like=True, tag="welcome", forbid_unknown_fields=True):
    """The runtime's answer: signals go on after `seq`; not resumed means that all that was known before is void."""

    version: Count
    epoch: Name
    seq: Count
    resumed: bool
    clock_ns: Count


class RequestPacket(msgspec.Struct, frozen=True, array_like=True, tag="request", forbid_unknown_fields=True):
    """A question; every number below `done_below` is settled for the asker; deadline on the runtime's clock, 0 none."""

    number: Count
    done_below: Count
    deadline_ns: Count
    parts: Count
    body: bytes


class ReplyPacket(msgspec.Struct, frozen=True, array_like=True, tag="reply", forbid_unknown_fields=True):
    """The answer to the request of that number; late: it came after its deadline and was not carried out."""

    number: Count
    late: bool
    parts: Count
    body: bytes


class Part(msgspec.Struct, frozen=True, array_like=True, tag="part", forbid_unknown_fields=True):
    """A piece of the body of the request or reply of that number, which follows with the last piece."""

    number: Count
    index: Count
    body: bytes


class SignalPacket(msgspec.Struct, frozen=True, array_like=True, tag="signal", forbid_unknown_fields=True):
    """The signal of that number in the runtime's epoch."""

    seq: Count
    body: bytes


class Ack(msgspec.Struct, frozen=True, array_like=True, tag="ack", forbid_unknown_fields=True):
    """All signals up to this one have been accepted."""

    seq: Count


class ReadingPacket(msgspec.Struct, frozen=True, array_like=True, tag="reading", forbid_unknown_fields=True):
    """The newest value under a key; `count` grows from reading to reading, so that an overtaken one is known."""

    count: Count
    key: Name
    body: bytes


class Beat(msgspec.Struct, frozen=True, array_like=True, tag="beat", forbid_unknown_fields=True):
    """I am here: how many beats on this connection so far, and the sender's own clock."""

    count: Count
    clock_ns: Count
    round_trip_us: Annotated[int, msgspec.Meta(ge=-1, le=2**63 - 1)] = -1
    """Of one that came as a datagram: the shortest round trip of the connection; -1: it came over the connection."""


class Bye(msgspec.Struct, frozen=True, array_like=True, tag="bye", forbid_unknown_fields=True):
    """The last word on a connection and why.

    With the cause `version` the reason is a sentence in English, which every version of the link can read.
    """

    cause: Literal["closed", "version", "garbage", "behind", "refused"]
    reason: Sentence | Reason


Packet = Hello | Welcome | RequestPacket | ReplyPacket | Part | SignalPacket | Ack | ReadingPacket | Beat | Bye

_LONGEST = 300
"""Characters that are said of why bytes are no packet: they may be a million letters in the place of a word."""

_encoder = msgspec.msgpack.Encoder()
_decoder: msgspec.msgpack.Decoder[Packet] = msgspec.msgpack.Decoder(Packet)


def encode(packet: Packet) -> bytes:
    """The packet as bytes (MessagePack)."""
    return _encoder.encode(packet)


def decode(payload: bytes) -> Packet:
    """The packet these bytes are; raises ValueError when they are none, or more than one."""
    try:
        return _decoder.decode(payload)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as fault:
        why = Reason.plain(str(fault)[:_LONGEST])
        raise ValueError(Reason.of("link.no_packet", count=len(payload), why=why)) from None
