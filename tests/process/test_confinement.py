import json
import socket
import subprocess
import sys

import pytest

from onika.process import confinement

CHILD = """
import json, os, socket, sys
from pathlib import Path
from onika.process import confinement

inside, outside, port = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3])
places = ["/usr", "/lib", "/lib64", "/proc", "/etc", sys.prefix, sys.base_prefix]
confinement.confine([*map(Path, places), inside / "absent"], [inside, Path("/dev/null")])


def tried(do):
    try:
        do()
    except OSError as wrong:
        return type(wrong).__name__
    return "done"


print(json.dumps({
    "writes within": tried(lambda: (inside / "a").write_text("a")),
    "reads a system file": tried(lambda: Path("/proc/self/status").read_text()),
    "reads outside": tried(lambda: (outside / "secret").read_text()),
    "lists outside": tried(lambda: os.listdir(outside)),
    "writes outside": tried(lambda: (outside / "a").write_text("a")),
    "links to outside": tried(lambda: os.link(outside / "secret", inside / "b")),
    "signals its parent": tried(lambda: os.kill(os.getppid(), 0)),
    "looks into its parent": tried(lambda: open(f"/proc/{os.getppid()}/environ").read()),
    "connects": tried(lambda: socket.create_connection(("127.0.0.1", port), 1.0)),
}))
"""
"""What is refused depends on the version: 4 knows of TCP, 6 of signals."""


@pytest.fixture(scope="module")
def tries(tmp_path_factory):
    inside, outside = tmp_path_factory.mktemp("inside"), tmp_path_factory.mktemp("outside")
    (outside / "secret").write_text("nobody's business")
    with socket.create_server(("127.0.0.1", 0)) as listening:
        words = [sys.executable, "-c", CHILD, str(inside), str(outside), str(listening.getsockname()[1])]
        return subprocess.run(words, capture_output=True, text=True, timeout=60, check=False)


def test_a_confined_process_reaches_its_own_folder_and_nothing_else(tries):  # R-X25
    level = confinement.level()
    if not level:
        assert "no Landlock" in tries.stderr
        return
    wanted = {"writes within": "done", "reads a system file": "done"}
    refused = ["reads outside", "lists outside", "writes outside", "looks into its parent"]
    refused += ["connects"] * (level >= 4) + ["signals its parent"] * (level >= 6)
    outcome = json.loads(tries.stdout)
    assert {name: outcome[name] for name in wanted} == wanted
    assert {name: outcome[name] for name in refused} == dict.fromkeys(refused, "PermissionError")
    assert outcome["links to outside"] != "done"
