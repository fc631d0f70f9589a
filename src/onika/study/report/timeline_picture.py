"""A task as a timeline: what each stretch of time was for, in lanes, with the event that ended it (§E.4, figure 25)."""

from collections.abc import Iterator, Sequence
from html import escape
from itertools import pairwise

from onika.study.log import LogEntry
from onika.study.report.box_plot import ticks_of
from onika.study.session import RUN, TRY_RUN, is_completion, is_end

WIDTH = 980
_LEFT, _RIGHT, _TOP, _LANE, _BOTTOM = 110, 20, 8, 22, 34
LANES = ("selection", "insertion", "deletion", "check", "run", "other")
_COLOURS = {
    "selection": "--c0",
    "insertion": "--c2",
    "deletion": "--c1",
    "check": "--c4",
    "run": "--c3",
    "other": "--c5",
}


def drawn(entries: Sequence[LogEntry], names: dict[str, str], label: str) -> str:
    """The picture as SVG; `names` are what lanes are called."""
    height = _TOP + len(LANES) * _LANE + _BOTTOM
    begin = entries[0].at_s
    span = max(entries[-1].at_s - begin, 1.0)
    body = "".join([*_grid(span, names, height), *_stretches(entries, begin, span)])
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" '
        f'role="img" aria-label="{escape(label)}">{body}</svg>'
    )


def lane_of(entry: LogEntry) -> str:
    """The lane of the time that an event ends."""
    match entry.event:
        case "select_icon" if entry.window == "dict":
            return "selection"
        case "insert_icon" if entry.window == "appl":
            return "insertion"
        case "delete_icon" | "cut_icon" if entry.window == "appl":
            return "deletion"
        case "run_appl" | "try_run_appl":
            return "check"
    return "other"


def _grid(span: float, names: dict[str, str], height: int) -> Iterator[str]:
    for index, lane in enumerate(LANES):
        y = _TOP + (index + 0.5) * _LANE
        yield f'<text x="{_LEFT - 10}" y="{y + 4:.1f}" text-anchor="end">{escape(names[lane])}</text>'
        yield f'<path class="grid" d="M{_LEFT} {y:.1f}H{WIDTH - _RIGHT}"/>'
    for tick in ticks_of(0.0, span, 8):
        if tick <= span:
            x = _across(tick, span)
            yield f'<path class="grid" d="M{x:.1f} {_TOP}V{height - _BOTTOM}"/>'
            yield f'<text class="dim" x="{x:.1f}" y="{height - 16}" text-anchor="middle">{tick:g} s</text>'


def _stretches(entries: Sequence[LogEntry], begin: float, span: float) -> Iterator[str]:
    is_running = False
    for before, entry in pairwise(entries):
        lane = "run" if is_running else lane_of(entry)
        x, end = _across(before.at_s - begin, span), _across(entry.at_s - begin, span)
        y = _TOP + LANES.index(lane) * _LANE + 4
        thing = "" if entry.object == "none" else f" {entry.object}"
        title = f"{entry.at_s - begin:.1f} s: {entry.event}{thing} (+{entry.at_s - before.at_s:.1f} s)"
        yield f'<rect x="{x:.1f}" y="{y}" width="{max(end - x, 1.2):.1f}" height="{_LANE - 8}" rx="2" '
        yield f'fill="var({_COLOURS[lane]})"><title>{escape(title)}</title></rect>'
        yield from _mark(entry, end)
        is_running = (is_running or entry.event == RUN) and not is_end(entry)


def _mark(entry: LogEntry, x: float) -> Iterator[str]:
    """An attempt as a triangle, a run that completed as a tick, any other end as a cross."""
    y = _TOP + (LANES.index("run") + 0.5) * _LANE
    if entry.event in (RUN, TRY_RUN):
        yield f'<path d="M{x - 5:.1f} {y - 6}l8 6l-8 6z" fill="var(--ink)"/>'
    elif is_completion(entry):
        yield f'<path d="M{x - 6:.1f} {y}l4 5l8 -10" fill="none" stroke="var(--ink)" stroke-width="2.5"/>'
    elif is_end(entry):
        yield f'<path d="M{x - 5:.1f} {y - 5}l10 10m0 -10l-10 10" fill="none" stroke="var(--ink)" stroke-width="2.5"/>'


def _across(seconds: float, span: float) -> float:
    return _LEFT + (WIDTH - _LEFT - _RIGHT) * seconds / span
