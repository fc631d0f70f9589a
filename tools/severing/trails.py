"""What flows wrote down of what they did, and what follows from that: who was alone, and for how long."""

from collections.abc import Sequence
from pathlib import Path

Trail = list[tuple[str, int, int]]


def trail(path: Path) -> Trail:
    """What a flow wrote: what, of which step, when in ns."""
    lines = path.read_text().splitlines() if path.exists() else []
    rows = (line.split() for line in lines if line.count(" ") == 2)
    return [(what, int(step), int(at_ns)) for what, step, at_ns in rows]


def segments(own: Trail) -> list[tuple[int, int, int]]:
    """Each time that a step was gone through: the step, its first cycle and its last one, in ns."""
    found: list[tuple[int, int, int]] = []
    for what, step, at_ns in own:
        if what == "begin":
            found.append((step, at_ns, at_ns))
        elif found and found[-1][0] == step:
            found[-1] = step, found[-1][1], at_ns
    return found


def joined(other: Trail, step: int, begin_ns: int) -> int:
    """From when on another flow is in this step with somebody who began it then, or has done it; else never."""
    times = [at_ns for what, number, at_ns in other if number == step and what == "done"]
    times += [at_ns for what, number, at_ns in other if number == step and what == "begin" and at_ns > begin_ns - 10**8]
    times += [at_ns for what, number, at_ns in other if number > step]
    return max(begin_ns, min(times, default=2**63))


def skews(trails: Sequence[Trail]) -> list[float]:
    """How far apart first cycles of a step are that all have begun together, in us."""
    found = []
    for step, begin_ns, _ in segments(trails[0]):
        near = [
            [at for number, at, _ in segments(other) if number == step and abs(at - begin_ns) < 50_000_000]
            for other in trails[1:]
        ]
        if all(near):
            times = [begin_ns, *(at[0] for at in near)]
            found.append((max(times) - min(times)) / 1e3)
    return found
