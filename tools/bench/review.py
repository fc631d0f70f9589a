"""How long it takes to look at a recorded run: opening, glances, courses, the first difference.

Usage: python tools/bench/review.py [RUN.mcap] [--minutes M]. Without a file a virtual run is recorded and repeated in
the file until it is so long. An answer is timed as a page gets it, made into JSON; what is done aside is timed too.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import msgspec

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "src"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.initial_model import opened
from onika.record.reader import Reader
from onika.record.run import RunRecord
from onika.record.topics import EVENTS
from onika.record.writer import Writer
from onika.store.site import open_site
from onika.wire import act

_GLANCES = 200
_encode = msgspec.json.Encoder(enc_hook=str).encode


def main() -> None:
    """Print a line for each thing."""
    parser = argparse.ArgumentParser()
    parser.add_argument("file", type=Path, nargs="?")
    parser.add_argument("--minutes", type=float, default=10.0)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = given.file or _stretched(_recorded(Path(folder)), Path(folder) / "long.mcap", given.minutes * 60)
        site = open_site([], {}, None)
        _measure(EnvironmentFixture(Path(folder) / "base", model=opened(site, None, {})[0], site=site), path)


def _measure(sitting: EnvironmentFixture, path: Path) -> None:
    _line("opened", lambda: sitting.later(act.OpenRecording(str(path))))
    view = sitting.environment.tree.review
    if view is None:
        raise SystemExit(f"{path} cannot be looked at")
    run = view.recording
    size = path.stat().st_size / 1e6
    print(f"{run.name}: {run.end_s:.0f} s, {size:.0f} MB, {len(run.variables)} variables, {len(run.marks)} marks")
    random = Random(1)
    times = sorted(_seconds(lambda: sitting.answer(act.Glance(random.uniform(0, run.end_s)))) for _ in range(_GLANCES))
    mean, most = sum(times) / len(times), times[-1]
    print(f"a glance: mean {mean * 1e3:.1f} ms, median {times[len(times) // 2] * 1e3:.1f} ms, most {most * 1e3:.1f} ms")
    reader = Reader(path)
    known = {f"/{name}": name for name in run.variables}
    name = known[max(known, key=reader.count)]
    print(f"{name}: {reader.count(f'/{name}')} values")
    _line("its course, read for the first time", lambda: sitting.later(act.Course(name, 0, run.end_s)))
    _line("its course again", lambda: sitting.later(act.Course(name, 0, run.end_s)))
    _line("ten seconds of it", lambda: sitting.later(act.Course(name, run.end_s / 2, run.end_s / 2 + 10)))
    _line("compared with itself", lambda: _compare(sitting, act.CompareWith(str(path))))


def _compare(sitting: EnvironmentFixture, asked: act.CompareWith) -> None:
    sitting.later(asked)
    while sitting.environment.tree.review is not None and sitting.environment.tree.review.difference is None:
        sitting.environment.become(sitting.changes.get())


def _line(what: str, do: Callable[[], Any]) -> None:
    print(f"{what}: {_seconds(do) * 1e3:.1f} ms", flush=True)


def _seconds(do: Callable[[], Any]) -> float:
    begin = time.perf_counter()
    answer = do()
    if answer is not None:
        _encode(answer.value)
    return time.perf_counter() - begin


# -- a long run


def _recorded(folder: Path) -> Path:
    path = folder / "run.mcap"
    words = [sys.executable, "-c", "from onika.cli import main; raise SystemExit(main())"]
    words += ["run", "assemble", "--virtual", "--record", str(path)]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    return path


def _stretched(path: Path, long: Path, seconds: float) -> Path:
    """The same run again and again in one file, as a loop would have it."""
    reader = Reader(path)
    with long.open("wb") as stream:
        writer = Writer(stream)
        RunRecord.read(reader).write(writer)
        numbers = {
            topic: writer.channel(topic, topic, b'{"type":"object"}', one.metadata)
            for topic, one in reader.channels.items()
        }
        lasted = reader.span[1] + 1
        said = [
            (at, number, place, body)
            for topic, number in numbers.items()
            for place, (at, body) in enumerate(reader.messages(topic))
        ]
        said.sort(key=lambda one: one[:3])
        for turn in range(max(round(seconds * 1e9 / lasted), 1)):
            for at, number, _, body in said:
                if number != numbers[EVENTS] or b'"type":"Result"' not in body:
                    writer.message(number, at + turn * lasted, body)
        writer.finish()
    return long


if __name__ == "__main__":
    main()
