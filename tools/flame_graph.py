"""Where the processor's time of a piece of work goes: the functions that take most, and a flame graph.

Usage: python tools/flame_graph.py NAME [--out FILE.svg] [--seconds S]. NAME is `loop` (four blocks, swept), `switch`
(24 actions that finish at once) or `assembly` (the box assembly in virtual time). Looks at the stack each millisecond
of processor time; Python lets it look where a function begins or a loop goes round, so what runs in C before is laid to
that. It is not called `profile`: a file of that name on the path would stand before Python's own.
"""

import argparse
import signal
import sys
from collections import Counter
from collections.abc import Callable
from html import escape
from pathlib import Path
from time import process_time
from types import FrameType

HOME = Path(__file__).parent
sys.path[:0] = [str(HOME / "bench"), str(HOME.parent / "tests")]

Stack = tuple[str, ...]
Box = tuple[int, float, float, str]
"""Depth, left edge and width as shares, function."""
_EVERY_S = 1e-3
_WIDTH, _ROW, _LEAST = 1200.0, 17, 0.001
"""Of the picture: pixels, and the share below which a function is left out."""


def sampled(work: Callable[[], object], seconds: float) -> Counter[Stack]:
    """How often each stack of functions was found while the work was repeated for so much processor time."""
    stacks: Counter[Stack] = Counter()

    def look(_signal: int, frame: FrameType | None) -> None:
        stack = []
        while frame is not None:
            stack.append(f"{Path(frame.f_code.co_filename).stem}.{frame.f_code.co_name}")
            frame = frame.f_back
        stacks[tuple(reversed(stack))] += 1

    former = signal.signal(signal.SIGPROF, look)
    signal.setitimer(signal.ITIMER_PROF, _EVERY_S, _EVERY_S)
    try:
        end = process_time() + seconds
        while process_time() < end:
            work()
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, former)
    return stacks


def shares(stacks: Counter[Stack]) -> list[tuple[float, str]]:
    """The share of each function itself, without those it calls, largest first."""
    own: Counter[str] = Counter()
    for stack, count in stacks.items():
        own[stack[-1]] += count
    return [(count / max(stacks.total(), 1), name) for name, count in own.most_common()]


def flame_graph(stacks: Counter[Stack]) -> str:
    """The stacks as a picture: as wide as long, callers below; a title at each tells function and share."""
    boxes: list[Box] = []
    _lay(stacks, 0, 0.0, stacks.total() or 1, boxes)
    height = (max((depth for depth, *_ in boxes), default=0) + 1) * _ROW
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH:g}" height="{height}" font-family="monospace">']
    for depth, left, share, name in boxes:
        y, width = height - (depth + 1) * _ROW, share * _WIDTH
        label = escape(name[: int(width / 6.5)]) if width > 20 else ""
        lines.append(
            f'<g><title>{escape(name)} {share:.1%}</title><rect x="{left * _WIDTH:.1f}" y="{y}" width="{width:.1f}" '
            f'height="{_ROW - 1}" fill="hsl({sum(name.encode()) % 50} 80% 70%)"/><text x="{left * _WIDTH + 2:.1f}" '
            f'y="{y + 12}" font-size="11">{label}</text></g>'
        )
    return "\n".join([*lines, "</svg>", ""])


def _lay(stacks: Counter[Stack], depth: int, left: float, total: int, boxes: list[Box]) -> None:
    """The boxes of all functions at this depth, from the left edge on, and of what they call."""
    callees: dict[str, Counter[Stack]] = {}
    for stack, count in stacks.items():
        if len(stack) > depth:
            callees.setdefault(stack[depth], Counter())[stack] += count
    for name, within in sorted(callees.items()):
        share = within.total() / total
        if share >= _LEAST:
            boxes.append((depth, left, share, name))
            _lay(within, depth + 1, left, total, boxes)
        left += share


def works() -> dict[str, Callable[[], Callable[[], object]]]:
    """What can be looked at, each prepared when it is asked for."""
    return {"loop": _loop, "switch": _switch, "assembly": _assembly}


def _loop() -> Callable[[], object]:
    from beside.loop.onika_blocks import Loop

    loop = Loop()
    loop.step(300)
    return lambda: loop.step(1000)


def _switch() -> Callable[[], object]:
    from beside.sequence.onika_application import Application

    return Application().run


def _assembly() -> Callable[[], object]:
    import virtual

    planned = virtual.prepare_run("assemble", virtual.open_site([], {}, None))
    assert planned.plan is not None, planned.faults
    prepared = virtual.prepare(planned.plan, planned.targets, virtual.ModuleFacts())
    return lambda: virtual.whole_run(prepared)


def main(words: list[str]) -> None:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("name", choices=works())
    parser.add_argument("--out", type=Path)
    parser.add_argument("--seconds", type=float, default=5.0)
    given = parser.parse_args(words)
    stacks = sampled(works()[given.name](), given.seconds)
    for share, name in shares(stacks)[:20]:
        print(f"{share:6.1%}  {name}")
    if given.out:
        given.out.write_text(flame_graph(stacks), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
