"""A hop with ZeroMQ: two PAIR sockets over ipc, blocking receive."""

import struct
import tempfile
from pathlib import Path

import zmq

from beside.contestant import Figures, serve
from beside.hop.partner import either, start
from beside.hop.vector import SIZE, hops

_FORM = struct.Struct(f"{SIZE}d")


def contestant() -> None:
    """Sends first."""
    with tempfile.TemporaryDirectory() as folder:
        address = f"ipc://{Path(folder) / 'hop'}"
        end = zmq.Context().socket(zmq.PAIR)
        end.bind(address)
        start("beside.hop.zmq_hop", (address,))

        def there_and_back(values: list[float]) -> list[float]:
            end.send(_FORM.pack(*values))
            return list(_FORM.unpack(end.recv()))

        def measure(count: int) -> Figures:
            return hops(there_and_back, count)

        serve(zmq.__version__, measure)


def partner(words: list[str]) -> None:
    """Sends back what it gets."""
    end = zmq.Context().socket(zmq.PAIR)
    end.connect(words[0])
    while True:
        end.send(end.recv())


if __name__ == "__main__":
    either(contestant, partner)
