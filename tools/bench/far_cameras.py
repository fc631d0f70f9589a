"""Pictures of three cameras at 10 Hz from a runtime on the other side of an ocean: what arrives, how old.

The runtime is at one site of a `FarLine`, whoever looks at another one, 100 ms away each way with 2 % of all packets
lost. While pictures come, questions are asked on the channel beside: they must not take longer than without pictures.
The cameras are a world of its own, which draws them: what is measured is packing, sending and reading. Run it as root,
with PYTHONPATH=tests.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from time import monotonic, monotonic_ns, process_time

sys.path.insert(0, str(Path(__file__).parents[1]))
from far_line import FarLine
from kit.plans.plan_builder import PlanBuilder
from kit.worlds.installed_world import install_world
from onika.desk.run.remote_runtime import RemoteRuntime
from onika.link.address import Address
from onika.link.websocket_opening import WebSocketOpening
from onika.wire import live, reading

CAMERAS = ("left", "right", "above")
HZ = 10
PORT = 7997
SIZES = ((128, 128), (320, 240))
WORLD = """
from time import monotonic_ns

import numpy as np

from kit.worlds.mass_world import MassWorld
from onika.ring.device import DeviceSheet
from onika.workcell.filmed.small_picture import small_picture

CAMERAS = {cameras!r}


class Eyes(MassWorld):
    def __init__(self):
        super().__init__()
        self._shown, self._number, self._next_ns, self._new = set(), 0, 0, {{}}
        chance, shape = np.random.default_rng(1), ({height}, {width}, 3)
        slope = np.linspace(30, 220, {width})[None, :, None]
        self._scenes = [np.clip(slope + chance.normal(0, 6, shape), 0, 255).astype(np.uint8) for _ in range(8)]

    def devices(self):
        state, facts = ("time", "drive", "number", "age"), {{"RATE": ({hz}.0,)}}
        sheets = (DeviceSheet(name, state, (), facts, ({height}, {width})) for name in CAMERAS)
        return (*super().devices(), *sheets)

    def state(self, device):
        return np.zeros(4) if device in CAMERAS else super().state(device)

    def release(self, device, epoch):
        if device not in CAMERAS:
            super().release(device, epoch)

    def picture(self, device):
        return self._scenes[0]

    def look(self, device, is_wanted):
        pass

    def show(self, device, is_shown):
        (self._shown.add if is_shown else self._shown.discard)(device)

    def take_small(self):
        if not self._shown or monotonic_ns() < self._next_ns:
            return {{}}
        self._next_ns = max(self._next_ns, monotonic_ns() - 10**8) + 10**9 // {hz}
        self._number += 1
        pixels = self._scenes[self._number % 8]
        return {{name: (self._number, monotonic_ns(), small_picture(pixels)) for name in self._shown}}
"""
MASS = """
from onika.module import Module

class Mass(Module):
    device = "m0"

    def cycle(self):
        self.device.read()
"""


def looked(url: str, token: str, ca: str, pid: int, seconds: float) -> dict[str, object]:
    """What whoever looks sees for so long, as figures; with and without pictures in turn for the questions."""
    shop = PlanBuilder()
    task = shop.task("mass", MASS, frequency=10.0, local={"DEVICE": "far:m0"})
    with RemoteRuntime(WebSocketOpening(Address.parse(url), token, Path(ca))) as runtime:
        change = live.Change("main", spawn=(task,), code=(shop.code("mass"),))
        accepted = runtime.ask(change)
        assert isinstance(accepted, live.Accepted), accepted
        alone_ms = [_question_ms(runtime) for _ in range(20)]
        without = _share(pid, seconds / 3, lambda: list(runtime.events(0.02)))
        names = tuple(f"far:{name}" for name in CAMERAS)
        runtime.ask(live.Attend((), (), names, 4.0 * HZ))
        ages: dict[str, list[float]] = {name: [] for name in names}
        beside_ms: list[float] = []
        used_s, before_s, size = process_time(), _used_s(pid), 0
        while not list(runtime.events(0.02)) and not runtime.readings():
            pass  # what it takes until the first picture is there is not the line's pace
        begin, asked = monotonic(), monotonic()
        while monotonic() < begin + seconds:
            list(runtime.events(0.02))
            for key, body in runtime.readings().items():
                shown = reading.decode(body)
                if isinstance(shown, reading.CameraPicture):
                    ages[key.removeprefix("world:")].append((monotonic_ns() - shown.at_ns) * 1e-6)
                    size = len(shown.file)
            if monotonic() > asked + 1.0:
                asked = monotonic()
                beside_ms.append(_question_ms(runtime))
        used_s, lasted_s = process_time() - used_s, monotonic() - begin
        beside = (_used_s(pid) - before_s) / lasted_s
    every = sorted(age for of_camera in ages.values() for age in of_camera)
    wanted = HZ * len(CAMERAS) * seconds
    return {
        "arrive": len(every) / wanted, "least_hz": min(map(len, ages.values())) / seconds, "bytes": size,
        "p50_ms": _part(every, 0.5), "p99_ms": _part(every, 0.99), "reader_share": used_s / seconds,
        "runtime_share": beside, "runtime_share_without": without,
        "question_ms": _part(sorted(beside_ms), 0.5), "question_alone_ms": _part(sorted(alone_ms), 0.5),
    }  # fmt: skip


def _question_ms(runtime: RemoteRuntime) -> float:
    begin = monotonic()
    runtime.ask(live.Survey())
    return (monotonic() - begin) * 1e3


def _part(values: Sequence[float], share: float) -> float:
    return values[min(len(values) - 1, int(share * len(values)))] if values else float("nan")


def measure(folder: Path, size: tuple[int, int], delay_s: float, loss: float, seconds: float) -> dict[str, object]:
    """The figures of one line."""
    users, certificate = folder / "users", folder / "tls"
    words = [sys.executable, "-m", "onika.host.sessions.users", "owner", "owner", str(users)]
    token = subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()
    _certify(certificate)
    source = WORLD.format(cameras=CAMERAS, height=size[1], width=size[0], hz=HZ)
    (folder / "world").mkdir()
    install_world(folder / "world", "far", source, "Eyes")
    paths = os.pathsep.join(map(str, (folder / "world", *map(os.path.abspath, ("tests", "tools/bench")))))
    environment = os.environ | {"XDG_STATE_HOME": str(folder), "PYTHONPATH": paths}
    with FarLine(2, delay_s, jitter_s=delay_s / 10, loss=loss) as line:
        host = [sys.executable, "-m", "onika.host", "--listen", f"{line.address(0)}:{PORT}", "--users", str(users)]
        host += ["--cert", f"{certificate}.crt", "--key", f"{certificate}.key", "--no-black-box", "--accept-code"]
        runtime = subprocess.Popen(line.within(0, host), stdout=subprocess.PIPE, env=environment)
        try:
            assert runtime.stdout is not None
            runtime.stdout.readline()
            looking = [sys.executable, __file__, "--look", f"wss://{line.address(0)}:{PORT}", token]
            looking += [f"{certificate}.crt", str(runtime.pid), "--seconds", str(seconds)]
            said = subprocess.run(line.within(1, looking), check=True, stdout=subprocess.PIPE, env=environment).stdout
        finally:
            runtime.terminate()
            runtime.wait(20)
    return json.loads(said)


def _share(pid: int, seconds: float, do: Callable[[], object]) -> float:
    """Of one core, what a process and its descendants use while something is done again and again."""
    begin, before_s = monotonic(), _used_s(pid)
    while monotonic() < begin + seconds:
        do()
    return (_used_s(pid) - before_s) / (monotonic() - begin)


def _used_s(pid: int) -> float:
    """Seconds of a processor that a process and its descendants have used."""
    children: dict[int, list[int]] = {}
    used: dict[int, float] = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        number = int(path.parent.name)
        children.setdefault(int(fields[1]), []).append(number)
        used[number] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    total_s, left = 0.0, [pid]
    while left:
        number = left.pop()
        total_s += used.get(number, 0.0)
        left += children.get(number, [])
    return total_s


def _certify(path: Path) -> None:
    request = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"]
    request += ["-keyout", f"{path}.key", "-out", f"{path}.crt", "-subj", "/CN=far"]
    request += ["-addext", "subjectAltName=IP:10.9.0.1"]
    subprocess.run(request, check=True, capture_output=True)
    Path(f"{path}.key").chmod(0o600)


def main() -> None:
    """Measure, and print a line for each line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--delay-ms", type=float, default=100.0, help="one way")
    parser.add_argument("--loss", type=float, default=0.02)
    parser.add_argument("--far", action="store_true", help="only the far line")
    parser.add_argument("--look", nargs=4, metavar=("URL", "TOKEN", "CA", "PID"), help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.look:
        url, token, ca, pid = given.look
        print(json.dumps(looked(url, token, ca, int(pid), given.seconds)))
        return
    if os.geteuid() != 0:
        print("network namespaces need root: nothing was measured")
        return
    for delay_s, loss in ((0.0, 0.0),) * (not given.far) + ((given.delay_ms / 1e3, given.loss),):
        for size in SIZES:
            with tempfile.TemporaryDirectory() as folder:
                figures = measure(Path(folder), size, delay_s, loss, given.seconds)
            words = " ".join(f"{name} {value:.3g}" for name, value in figures.items())
            line = f"{1e3 * delay_s:.0f} ms each way, {100 * loss:.1f} % lost"
            print(f"{size[0]} x {size[1]}, {line}: {words}", flush=True)


if __name__ == "__main__":
    main()
