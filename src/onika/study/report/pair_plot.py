"""Differences of groups with their simultaneous limits, as lines beside a zero (requirement H03, table 4)."""

import math
from collections.abc import Iterator, Sequence
from html import escape

from onika.study.comparison import PairComparison
from onika.study.report.box_plot import ticks_of

WIDTH = 640
_LEFT, _RIGHT, _ROW, _BOTTOM = 200, 24, 30, 30


def drawn(pairs: Sequence[PairComparison], label: str) -> str:
    """The picture as SVG; pairs without limits are left out."""
    whole = [pair for pair in pairs if math.isfinite(pair.low) and math.isfinite(pair.high)]
    height = len(whole) * _ROW + _BOTTOM + 10
    ends = [0.0, *(pair.low for pair in whole), *(pair.high for pair in whole)]
    ticks = ticks_of(min(ends), max(ends))
    body = "".join([*_axis(ticks, height), *_pairs(whole, ticks)])
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" '
        f'role="img" aria-label="{escape(label)}">{body}</svg>'
    )


def _axis(ticks: Sequence[float], height: int) -> Iterator[str]:
    for tick in ticks:
        kind = ("grid", "axis")[tick == 0.0]
        x = _across(tick, ticks)
        yield f'<path class="{kind}" d="M{x:.1f} 6V{height - _BOTTOM}"/>'
        yield f'<text class="dim" x="{x:.1f}" y="{height - 12}" text-anchor="middle">{tick:g}</text>'


def _pairs(pairs: Sequence[PairComparison], ticks: Sequence[float]) -> Iterator[str]:
    for index, pair in enumerate(pairs):
        y = 6 + _ROW * (index + 0.5)
        low, middle, high = (_across(value, ticks) for value in (pair.low, pair.difference, pair.high))
        is_apart = pair.low > 0.0 or pair.high < 0.0
        colour = ("var(--c0)", "var(--c1)")[is_apart]
        name = escape(f"{pair.first} − {pair.second}")
        yield f'<text x="{_LEFT - 12}" y="{y + 4:.1f}" text-anchor="end">{name}</text>'
        yield f'<path d="M{low:.1f} {y:.1f}H{high:.1f}M{low:.1f} {y - 5:.1f}v10M{high:.1f} {y - 5:.1f}v10" '
        yield f'stroke="{colour}" stroke-width="2" fill="none"/>'
        yield f'<circle cx="{middle:.1f}" cy="{y:.1f}" r="4.5" fill="{colour}"/>'


def _across(value: float, ticks: Sequence[float]) -> float:
    return _LEFT + (WIDTH - _LEFT - _RIGHT) * (value - ticks[0]) / (ticks[-1] - ticks[0])
