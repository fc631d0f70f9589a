"""What a world and the process that renders for its cameras say to each other: datagrams in msgpack."""

from collections.abc import Mapping, Sequence

from msgspec import Struct, msgpack

from onika.wire.world_source import WorldSource
from onika.words.reason import Reason


class Eye(Struct, frozen=True):
    """A camera of the document, and the size of its pictures; they lie in the shared memory from `offset` on."""

    name: str
    width: int
    height: int
    offset: int


class Film(Struct, frozen=True):
    """What is known from the beginning: the files of the world and its cameras."""

    files: WorldSource
    eyes: tuple[Eye, ...]
    source: str = ""
    """Of a real camera what is opened: its number or path, a film, a row of pictures; empty: cameras are rendered."""


class Exposure(Struct, frozen=True):
    """A picture that is wanted of an instant: which robot stands where, all positions, the shapes that shine.

    eye       the number of the camera
    taken_ns  the world's time
    """

    eye: int
    taken_ns: int
    standing: dict[str, str]
    qpos: bytes
    lit: tuple[str, ...]
    is_shown: bool = False
    """Whether somebody looks at it, who is to be sent it in a small form."""


class Exposed(Struct, frozen=True):
    """The picture lies in the shared memory; `small` is it as JPEG or PNG where somebody looks, else empty.

    `why` says what keeps it from being there, where anything does.
    """

    eye: int
    taken_ns: int
    small: bytes = b""
    why: Reason | None = None


encode = msgpack.Encoder().encode
decode_film = msgpack.Decoder(Film).decode
decode_exposure = msgpack.Decoder(Exposure).decode
decode_exposed = msgpack.Decoder(Exposed).decode


def laid_out(cameras: Sequence[tuple[str, tuple[int, ...]]]) -> tuple[Eye, ...]:
    """Cameras by their names in the document, with height and width, one behind the other in the memory."""
    eyes, end = list[Eye](), 0
    for name, (height, width) in cameras:
        eyes.append(Eye(name, width, height, end))
        end += -(-3 * width * height // _PAGE) * _PAGE
    return tuple(eyes)


def room_of(eyes: Sequence[Eye]) -> int:
    """Bytes of memory that these pictures take."""
    return max((eye.offset + 3 * eye.width * eye.height for eye in eyes), default=0) or _PAGE


Standing = Mapping[str, str]
"""Which robot stands at each place."""

_PAGE = 4096
