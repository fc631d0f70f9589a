"""Groups as box plots: box from quartile to quartile, line at the median, whiskers, every subject as a point (H03).

Whiskers reach the outermost value within one and a half times the height of the box (Tukey); the diamond is the mean.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from html import escape

import numpy as np

WIDTH, HEIGHT = 640, 300
_LEFT, _RIGHT, _TOP, _BOTTOM = 64, 16, 14, 44
_COLOURS = 5
_WHISKER = 1.5


def drawn(groups: Mapping[str, Sequence[tuple[str, float]]], label: str) -> str:
    """The picture as SVG; the points of a group are names of subjects with their values."""
    values = [value for group in groups.values() for _, value in group]
    ticks = ticks_of(min(values, default=0.0), max(values, default=1.0))
    body = "".join([*_axis(ticks, label), *_groups(groups, ticks)])
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
        f'role="img" aria-label="{escape(label)}">{body}</svg>'
    )


def ticks_of(low: float, high: float, about: int = 5) -> list[float]:
    """Round numbers from at most `low` to at least `high`."""
    if high - low < 1e-9 * max(abs(low), abs(high), 1.0):
        low, high = low - 0.5, high + 0.5
    rough = (high - low) / about
    size = 10.0 ** math.floor(math.log10(rough))
    step = next(factor * size for factor in (1.0, 2.0, 2.5, 5.0, 10.0) if factor * size >= rough * (1.0 - 1e-9))
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [round(number * step, 10) for number in range(first, last + 1)]


def _axis(ticks: Sequence[float], label: str) -> Iterator[str]:
    for tick in ticks:
        y = _up(tick, ticks)
        yield f'<path class="grid" d="M{_LEFT} {y:.1f}H{WIDTH - _RIGHT}"/>'
        yield f'<text class="dim" x="{_LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{tick:g}</text>'
    middle = (_TOP + HEIGHT - _BOTTOM) / 2
    yield f'<text x="14" y="{middle}" text-anchor="middle" transform="rotate(-90 14 {middle})">{escape(label)}</text>'


def _groups(groups: Mapping[str, Sequence[tuple[str, float]]], ticks: Sequence[float]) -> Iterator[str]:
    wide = (WIDTH - _LEFT - _RIGHT) / max(len(groups), 1)
    for index, (name, points) in enumerate(groups.items()):
        x = _LEFT + wide * (index + 0.5)
        colour = f"var(--c{index % _COLOURS})"
        title = f"{name} ({len(points)})"
        yield f'<text x="{x:.1f}" y="{HEIGHT - 18}" text-anchor="middle">{escape(title)}</text>'
        if points:
            yield from _box([value for _, value in points], x, min(wide * 0.3, 56.0), ticks, colour)
            yield from _points(points, x, min(wide * 0.3, 56.0), ticks, colour)


def _box(values: Sequence[float], x: float, half: float, ticks: Sequence[float], colour: str) -> Iterator[str]:
    lower, median, upper = (float(quartile) for quartile in np.percentile(values, (25, 50, 75)))
    reach = _WHISKER * (upper - lower)
    low = min(value for value in values if value >= lower - reach)
    high = max(value for value in values if value <= upper + reach)
    top, bottom = _up(upper, ticks), _up(lower, ticks)
    line = f'stroke="{colour}" stroke-width="1.5"'
    yield f'<rect x="{x - half:.1f}" y="{top:.1f}" width="{2 * half:.1f}" height="{bottom - top:.1f}" fill="{colour}" '
    yield f'fill-opacity=".14" {line}/>'
    yield f'<path d="M{x - half:.1f} {_up(median, ticks):.1f}h{2 * half:.1f}" stroke="{colour}" stroke-width="3"/>'
    for whisker, begin in ((high, top), (low, bottom)):
        y = _up(whisker, ticks)
        yield f'<path fill="none" d="M{x:.1f} {begin:.1f}V{y:.1f}M{x - half / 2:.1f} {y:.1f}h{half:.1f}" {line}/>'
    mean = _up(sum(values) / len(values), ticks)
    yield f'<path d="M{x:.1f} {mean - 6:.1f}l6 6l-6 6l-6 -6z" fill="var(--panel)" stroke="var(--ink)"/>'


def _points(
    points: Sequence[tuple[str, float]], x: float, half: float, ticks: Sequence[float], colour: str
) -> Iterator[str]:
    for index, (name, value) in enumerate(points):
        aside = x + half + 14 + 9 * (index % 2)
        yield f'<circle cx="{aside:.1f}" cy="{_up(value, ticks):.1f}" r="3.5" fill="{colour}">'
        yield f"<title>{escape(f'{name}: {value:g}')}</title></circle>"


def _up(value: float, ticks: Sequence[float]) -> float:
    share = (value - ticks[0]) / (ticks[-1] - ticks[0])
    return HEIGHT - _BOTTOM - share * (HEIGHT - _TOP - _BOTTOM)
