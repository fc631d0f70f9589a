"""The channels of a session: questions, signals and readings, on one connection or each on its own (§5.8.2)."""

from enum import Enum

from onika.wire.packet import (
    Ack,
    Beat,
    Bye,
    Hello,
    Packet,
    Part,
    ReadingPacket,
    ReplyPacket,
    RequestPacket,
    SignalPacket,
    Welcome,
)

_EVERYWHERE = (Hello, Welcome, Beat, Bye)


class Channel(Enum):
    """What a connection is for; the value is the path of its address."""

    ALL = ""
    """Everything, for a child process and for simple clients."""
    SESSION = "session"
    SIGNAL = "signal"
    STREAM = "stream"

    __hash__ = object.__hash__  # by identity, which is quick; these are keys everywhere

    def carries(self, packet: Packet) -> bool:
        """Whether the packet has its place here, whoever says it."""
        return self is Channel.ALL or isinstance(packet, (*_EVERYWHERE, *_OWN[self]))

    @property
    def asks(self) -> bool:
        """Whether requests go here, so that a session stands and falls with it."""
        return self in (Channel.ALL, Channel.SESSION)


THREE = (Channel.SESSION, Channel.SIGNAL, Channel.STREAM)
"""Over a network: a picture on its way holds up no signal."""

_OWN: dict[Channel, tuple[type, ...]] = {
    Channel.ALL: (),
    Channel.SESSION: (RequestPacket, ReplyPacket, Part),
    Channel.SIGNAL: (SignalPacket, Ack),
    Channel.STREAM: (ReadingPacket,),
}
