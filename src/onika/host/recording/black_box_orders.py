"""What is said to whoever holds the last seconds of runs, and what it answers."""

from msgspec import Struct, msgpack

from onika.host.recording.last_seconds import TracedEvent, TracedVariables
from onika.record.run import RunRecord
from onika.words.reason import Reason


class OpenBlackBox(Struct, frozen=True, tag=True):
    """A run begins, and its last seconds are to be held; the description of the run comes as memory."""

    number: int
    path: str
    """Where they are written if it ends badly."""
    began_ns: int
    """By the clock by which whoever holds them looks."""
    every_ns: int
    """How often it looks."""


class DescribeBlackBox(Struct, frozen=True, tag=True):
    """What is held consists of something else now; the description comes as memory."""

    number: int


class CloseBlackBox(Struct, frozen=True, tag=True):
    """A run is over: its last seconds are written, or forgotten. The words are those of its end."""

    number: int
    is_kept: bool
    words: dict[str, str]


class KeepBlackBox(Struct, frozen=True, tag=True):
    """Something went wrong in a run that goes on: its last seconds are written now, into a file of their own."""

    number: int
    path: str
    words: dict[str, str]


class BlackBoxWritten(Struct, frozen=True, tag=True):
    """A black box of a run is written, or why not."""

    number: int
    reason: Reason
    path: str = ""


class RunOrder(Struct, frozen=True):
    """An order, and the run that it concerns."""

    number: int
    order: OpenBlackBox | DescribeBlackBox | TracedVariables | TracedEvent | KeepBlackBox | CloseBlackBox


encode = msgpack.Encoder().encode
decode_order = msgpack.Decoder(RunOrder).decode
encode_word = msgpack.Encoder().encode
decode_word = msgpack.Decoder(BlackBoxWritten).decode
encode_run = msgpack.Encoder().encode
decode_run = msgpack.Decoder(RunRecord).decode
