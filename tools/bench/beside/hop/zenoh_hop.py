"""A hop with Zenoh: two peers on TCP of the loopback, no scouting, a subscriber with a channel that is waited for."""

import socket
import struct
from importlib.metadata import version
from typing import Any

import zenoh

from beside.contestant import Figures, serve
from beside.hop.partner import either, start
from beside.hop.vector import SIZE, hops

_FORM = struct.Struct(f"{SIZE}d")
_THERE, _BACK = "hop/there", "hop/back"


def session(endpoint: str, key: str) -> Any:
    """A peer that listens or connects at one address only."""
    config = zenoh.Config()
    config.insert_json5("mode", '"peer"')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("listen/endpoints", "[]")
    config.insert_json5("transport/shared_memory/enabled", "false")
    config.insert_json5(key, f'["{endpoint}"]')
    return zenoh.open(config)


def contestant() -> None:
    """Sends first."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        endpoint = f"tcp/127.0.0.1:{free.getsockname()[1]}"
    own = session(endpoint, "listen/endpoints")
    publisher = own.declare_publisher(_THERE, congestion_control=zenoh.CongestionControl.BLOCK, express=True)
    subscriber = own.declare_subscriber(_BACK)
    start("beside.hop.zenoh_hop", (endpoint,))
    subscriber.recv()  # the partner is there

    def there_and_back(values: list[float]) -> list[float]:
        publisher.put(_FORM.pack(*values))
        return list(_FORM.unpack(subscriber.recv().payload.to_bytes()))

    def measure(count: int) -> Figures:
        return hops(there_and_back, count)

    serve(version("eclipse-zenoh"), measure)


def partner(words: list[str]) -> None:
    """Sends back what it gets."""
    own = session(words[0], "connect/endpoints")
    subscriber = own.declare_subscriber(_THERE)
    publisher = own.declare_publisher(_BACK, congestion_control=zenoh.CongestionControl.BLOCK, express=True)
    publisher.put(b"up")
    while True:
        publisher.put(subscriber.recv().payload.to_bytes())


if __name__ == "__main__":
    either(contestant, partner)
