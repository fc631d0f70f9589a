"""A hop as Onika's runtime does it: a ring of shared memory for the value, a datagram of the post to wake the other.

The receiver acts on each datagram as it comes, and waits in `select` where there is none, as a processing unit does
with commands.
"""

import select
import socket

import numpy as np

import onika
from beside.contestant import Figures, serve
from beside.hop.partner import either, start
from beside.hop.vector import BYTES, SIZE, hops
from onika.host.processes.process_socket import ProcessSocket
from onika.ring.segment import Segment
from onika.ring.slots import Ring

_WAKE = b"\x01"


class End:
    """One end: a ring to write, a ring to read, a post."""

    def __init__(self, post: ProcessSocket, segment: Segment, writes: int) -> None:
        self._post = post
        self.sent, self.got = np.zeros(SIZE), np.zeros(SIZE)
        rings = [Ring(segment.view, number * Ring.footprint(BYTES), BYTES) for number in range(2)]
        self._write = rings[writes].writer(self.sent.data.cast("B"))
        self._read = rings[1 - writes].refresher(self.got.data.cast("B"))

    def send(self) -> None:
        """Publish what lies in `sent`, and wake the other end."""
        self._write()
        self._post.send(_WAKE)

    def wait(self) -> bool:
        """Until woken; then `got` is what the other end has sent. False when it is gone."""
        post = self._post
        while post.receive() is None:
            if post.is_closed:
                return False
            select.select([post], [], [])
        self._read()
        return True


def contestant() -> None:
    """Sends first."""
    post, theirs = ProcessSocket.pair()
    segment = Segment.create("hop", 1 << 14)
    start("beside.hop.onika_hop", (str(theirs.fileno()), str(segment.fd)), (theirs.fileno(), segment.fd))
    theirs.close()
    end = End(post, segment, 0)
    end.wait()  # the partner is there

    def there_and_back(values: list[float]) -> list[float]:
        end.sent[:] = values
        end.send()
        end.wait()
        back: list[float] = end.got.tolist()
        return back

    def measure(count: int) -> Figures:
        return hops(there_and_back, count)

    serve(onika.__version__, measure)


def partner(words: list[str]) -> None:
    """Sends back what it gets."""
    post = ProcessSocket(socket.socket(fileno=int(words[0])))
    end = End(post, Segment.attach(int(words[1])), 1)
    end.send()
    while end.wait():
        end.sent[:] = end.got
        end.send()


if __name__ == "__main__":
    either(contestant, partner)
