"""A module in the process of a sandbox, asked as its unit asks it.

with process_sandbox(SOURCE) as sandbox:
    sandbox.asked(Call("on", 0.0, 0.01, 0, ({},)))
"""

from collections.abc import Iterator
from contextlib import contextmanager

from kit.runtime.executive_rig import ExecutiveRig
from onika.host.sandbox.sandbox_end import SandboxEnd
from onika.host.sandbox.sandboxes import Sandboxes
from onika.runtime.sandbox.sandbox_messages import Answer, Bind, Call, decode_answer, encode

PATIENCE_S = 20.0


class AskedSandbox:
    """Its module, which has no ports or binds them itself, is loaded and bound."""

    def __init__(self, end: SandboxEnd) -> None:
        self.end = end
        self.loaded = decode_answer(end.answer(PATIENCE_S))

    def asked(self, order: Bind | Call, patience_s: float = PATIENCE_S) -> Answer:
        """The answer to a message."""
        answer: Answer = decode_answer(self.end.ask(encode(order), patience_s))
        return answer

    def got(self, name: str) -> object:
        """What `get` says."""
        return self.asked(Call("get", 0.0, 0.01, 0, (name,)))


@contextmanager
def process_sandbox(source: str, path: str = "") -> Iterator[AskedSandbox]:
    """Begin it; it is ended with the test."""
    sandboxes = Sandboxes()
    spawn = ExecutiveRig().spawn_of("tried", source)
    try:
        begun = sandboxes.begin(spawn)
        asked = AskedSandbox(SandboxEnd(begun.post, begun.memory, begun.process))
        asked.asked(Bind((), {}))
        yield asked
    finally:
        sandboxes.close()
