"""Waits for what another process or thread says next over its socket."""

import select
from time import monotonic

from onika.host.processes.process_socket import ProcessSocket

_PATIENCE_S = 30.0


def next_message(post: ProcessSocket) -> bytes:
    """The next message; raises TimeoutError where none comes."""
    until = monotonic() + _PATIENCE_S
    while monotonic() < until:
        select.select([post], [], [], 0.1)
        received = post.receive()
        if received is not None:
            return received[0]
    raise TimeoutError("nothing was said")
