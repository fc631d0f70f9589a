"""A sweep as a picture: the share of good runs over each number that was varied, and how long good runs last (X23).

Good and bad differ by place and shape too, not by colour alone.
"""

from collections.abc import Callable, Iterator, Sequence
from xml.sax.saxutils import escape

from onika.desk.sweep.case import CaseResult
from onika.desk.sweep.statistics import SweepSummary, VariedPart
from onika.words.reason import Reason

Say = Callable[[Reason], str]
_WIDTH, _LEFT, _RIGHT = 720, 64, 24
_PANEL, _GAP, _TOP, _BOTTOM = 150, 62, 56, 20
_COLUMNS = 24
_STYLE = """
text{font:13px system-ui,sans-serif;fill:#222}.head{font-size:16px;font-weight:600}.dim{fill:#666}
.axis{stroke:#888;stroke-width:1}.good{fill:#2a78c2}.bad{stroke:#b3261e;stroke-width:1.5}
.share{stroke:#2a78c2;stroke-width:2}.between{fill:#2a78c2;fill-opacity:.16}.bar{fill:#2a78c2;fill-opacity:.75}
@media(prefers-color-scheme:dark){svg{background:#1b1b1b}text{fill:#eee}.dim{fill:#aaa}
.good,.between,.bar{fill:#7db8ee}.share{stroke:#7db8ee}.bad{stroke:#ff8a80}}
"""


def drawn(name: str, results: Sequence[CaseResult], summary: SweepSummary, say: Say) -> str:
    """The picture as SVG."""
    panels: list[list[str]] = [
        [*_varied(variation, parts, results, say)] for variation, parts in summary.parts.items() if len(parts) > 1
    ]
    lasted = sorted(result.lasted_s for result in results if result.is_good)
    if len(lasted) > 1:
        panels.append([*_histogram(lasted, say(Reason.of("sweep.plot_lasted")))])
    height = _TOP + len(panels) * (_PANEL + _GAP) + _BOTTOM
    title = say(Reason.of("sweep.plot_title", name=name, good=summary.rate.good, count=summary.rate.count))
    body = "".join(
        f'<g transform="translate(0 {_TOP + number * (_PANEL + _GAP)})">{"".join(panel)}</g>'
        for number, panel in enumerate(panels)
    )
    head = f'<text class="head" x="{_LEFT}" y="30">{escape(title)}</text>'
    size = f'width="{_WIDTH}" height="{height}" viewBox="0 0 {_WIDTH} {height}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img"><style>{_STYLE}</style>{head}{body}</svg>\n'


def _varied(name: str, parts: Sequence[VariedPart], results: Sequence[CaseResult], say: Say) -> Iterator[str]:
    """Good runs as dots above, others as crosses below; between them the share of each part with its interval."""
    least, most = parts[0].least, parts[-1].most
    yield from _axes(say(Reason.of("sweep.plot_share")), ("0 %", "100 %"), name, (least, most))
    for part in parts:
        left, right = _at(part.least, least, most), _at(part.most, least, most)
        if left == right:
            left, right = left - 10, right + 10
        low, high = part.rate.interval
        yield f'<rect class="between" x="{left:.1f}" y="{_up(high):.1f}" width="{right - left:.1f}" '
        yield f'height="{_up(low) - _up(high):.1f}"/>'
        share = _up(part.rate.share)
        yield f'<path class="share" d="M{left:.1f} {share:.1f}H{right:.1f}"/>'
    for result in results:
        if name not in result.case.values:
            continue
        x = _at(result.case.values[name], least, most)
        if result.is_good:
            yield f'<circle class="good" cx="{x:.1f}" cy="-8" r="2"/>'
        else:
            yield f'<path class="bad" d="M{x - 3:.1f} {_PANEL - 6}l6 -6m-6 0l6 6"/>'


def _histogram(lasted: Sequence[float], label: str) -> Iterator[str]:
    least, most = lasted[0], lasted[-1]
    counts = [0] * _COLUMNS
    for seconds in lasted:
        counts[min(int((seconds - least) / ((most - least) or 1.0) * _COLUMNS), _COLUMNS - 1)] += 1
    yield from _axes("", ("0", str(max(counts))), label, (least, most))
    wide = (_WIDTH - _LEFT - _RIGHT) / _COLUMNS
    for number, count in enumerate(counts):
        tall = _PANEL * count / max(counts)
        yield f'<rect class="bar" x="{_LEFT + number * wide + 1:.1f}" y="{_PANEL - tall:.1f}" '
        yield f'width="{wide - 2:.1f}" height="{tall:.1f}"/>'


def _axes(up: str, marks: tuple[str, str], along: str, ends: tuple[float, float]) -> Iterator[str]:
    right, middle = _WIDTH - _RIGHT, (_LEFT + _WIDTH - _RIGHT) / 2
    yield f'<path class="axis" fill="none" d="M{_LEFT} 0V{_PANEL}H{right}"/>'
    yield f'<text class="dim" x="{_LEFT - 8}" y="{_PANEL}" text-anchor="end">{escape(marks[0])}</text>'
    yield f'<text class="dim" x="{_LEFT - 8}" y="10" text-anchor="end">{escape(marks[1])}</text>'
    yield f'<text class="dim" x="{_LEFT - 8}" y="{_PANEL / 2}" text-anchor="end">{escape(up)}</text>'
    yield f'<text class="dim" x="{_LEFT}" y="{_PANEL + 18}">{ends[0]:.4g}</text>'
    yield f'<text class="dim" x="{right}" y="{_PANEL + 18}" text-anchor="end">{ends[1]:.4g}</text>'
    yield f'<text x="{middle}" y="{_PANEL + 18}" text-anchor="middle">{escape(along)}</text>'


def _at(value: float, least: float, most: float) -> float:
    return _LEFT + (_WIDTH - _LEFT - _RIGHT) * ((value - least) / (most - least) if most > least else 0.5)


def _up(share: float) -> float:
    return _PANEL * (1.0 - share)
