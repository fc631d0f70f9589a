"""A hop with dora: two Python nodes of one dataflow under `dora run`, arrays of Arrow; no coordinator.

The dataflow stays up between rounds; sizes and figures go through two named pipes.
"""

import json
import os
import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path
from typing import Any

from beside.contestant import Figures, serve
from beside.hop.vector import hops

_SHARED = Path("/dev/shm")  # dora leaves a file of its Zenoh there

_FLOW = """
nodes:
  - id: sender
    path: {file}
    args: sender {folder}
    env: {{PYTHONPATH: "{paths}"}}
    inputs:
      back: echo/back
    outputs: [there]
  - id: echo
    path: {file}
    args: echo {folder}
    env: {{PYTHONPATH: "{paths}"}}
    inputs:
      there: sender/there
    outputs: [back]
"""


def contestant() -> None:
    """Keeps the dataflow and asks its sender."""
    beside = Path(sys.executable).parent  # dora starts nodes with the `python` that it finds first
    environment = os.environ | {"PATH": f"{beside}:{os.environ['PATH']}"}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for pipe in ("sizes", "figures"):
            os.mkfifo(folder / pipe)
        paths = os.environ["PYTHONPATH"]  # dora starts nodes without it
        (folder / "flow.yml").write_text(_FLOW.format(file=Path(__file__).resolve(), folder=folder, paths=paths))
        words = [str(beside / "dora"), "run", "flow.yml"]
        before = set(_SHARED.glob("*.zenoh"))
        flow = subprocess.Popen(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=sys.stderr)
        with (folder / "sizes").open("w") as sizes, (folder / "figures").open() as figures:

            def measure(count: int) -> Figures:
                print(count, file=sizes, flush=True)
                found: Figures = json.loads(figures.readline())
                return found

            serve(version("dora-rs"), measure)
        flow.wait()
    for left in set(_SHARED.glob("*.zenoh")) - before:
        left.unlink()


def sender(folder: Path) -> None:
    """Sends first."""
    import pyarrow as pa
    from dora import Node

    node = Node()

    def there_and_back(values: list[float]) -> list[float]:
        node.send_output("there", pa.array(values))
        return _value(node)

    with (folder / "sizes").open() as sizes, (folder / "figures").open("w") as figures:
        for line in sizes:
            print(json.dumps(hops(there_and_back, int(line))), file=figures, flush=True)


def echo() -> None:
    """Sends back what it gets."""
    from dora import Node

    node = Node()
    for event in node:
        if event["type"] == "INPUT":
            node.send_output("back", event["value"])


def _value(node: Any) -> list[float]:
    while True:
        event = node.next()
        if event is None:
            raise RuntimeError("the dataflow is over")
        if event["type"] == "INPUT":
            found: list[float] = event["value"].to_pylist()
            return found


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["sender", where]:
            sender(Path(where))
        case ["echo", _]:
            echo()
        case _:
            contestant()
