"""What was measured as tables of Markdown, and their place in the page: between two markers."""

from collections.abc import Sequence

from beside.contest import Contest, Outcome, Score
from beside.contests import Ladder
from beside.ladder import Rung

BEGIN = "<!-- measured: begin, written by make bench-peers -->"
END = "<!-- measured: end -->"


def put(page: str, measured: str) -> str:
    """The page with this between its markers; raises ValueError where they are not there once, in order."""
    head, begin, rest = page.partition(BEGIN)
    old, end, tail = rest.partition(END)
    if not (begin and end) or BEGIN in old + tail or END in tail:
        raise ValueError(f"expected {BEGIN} and then {END}, once each")
    return f"{head}{BEGIN}\n\n{measured.strip()}\n\n{END}{tail}"


def outcome_table(outcome: Outcome) -> str:
    """A heading and a table: ours first, then every peer, whether it won, lost or could not take part."""
    contest = outcome.contest
    extras = [heading for _, heading in contest.extras]
    head = ["", "version", f"{contest.unit}, median", "least to most", *extras, "ours / its", "goal", ""]
    rows = [[outcome.ours.entrant.name, outcome.ours.version, *_numbers(contest, outcome.ours), "", "", ""]]
    for peer in outcome.peers:
        if peer.absent:
            empty = [""] * (len(head) - 3)
            rows.append([peer.entrant.name, peer.version, *empty, f"not measured: {peer.absent}"])
            continue
        rows.append([peer.entrant.name, peer.version, *_numbers(contest, peer), *_judged(outcome, peer)])
    return f"### {contest.title}\n\n{_table(head, rows)}"


def ladder_table(ladder: Ladder, rungs: Sequence[Rung]) -> str:
    """A heading and a table, one line a size."""
    head = ["size", f"{ladder.unit}, median", "to the first"]
    head += [f"{ladder.unit} a piece"] if ladder.per_size else []
    head += [ladder.share] if ladder.share else []
    rows = []
    for rung in rungs:
        row = [f"{rung.size:,}", _figure(rung.figure), f"{rung.figure / rungs[0].figure:.2f}"]
        row += [_figure(rung.figure / rung.size)] if ladder.per_size else []
        row += [f"{rung.share:.2%}"] if rung.share is not None else []
        rows.append(row)
    return f"### {ladder.title}\n\n{_table(head, rows)}"


def left_out(title: str, why: str) -> str:
    """A heading, and why there is no table."""
    return f"### {title}\n\nNot measured: {why}."


def _numbers(contest: Contest, score: Score) -> list[str]:
    spread = f"{_figure(min(score.figures))} to {_figure(max(score.figures))}"
    return [_figure(score.figure), spread, *(_figure(score.extra(name)) for name, _ in contest.extras)]


def _judged(outcome: Outcome, peer: Score) -> list[str]:
    ratio, goal = outcome.ratio(peer), peer.entrant.goal
    lead = "Onika ahead" if ratio < 1.0 else "Onika behind"
    if goal is None:
        return [f"{ratio:.2f}", "", lead]
    return [f"{ratio:.2f}", f"{goal:.2f}", f"{lead}, goal {'met' if ratio <= goal else '**missed**'}"]


def _figure(value: float) -> str:
    if value and abs(value) < 10:
        return f"{value:.3g}"
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.1f}" if value else "0"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Columns are padded, so that it reads as plain text too."""
    cells = [[cell.replace("|", "/") for cell in row] for row in (head, *rows)]
    widths = [max(3, *(len(row[column]) for row in cells)) for column in range(len(head))]
    lines = [
        "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) + " |" for row in cells
    ]
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([lines[0], rule, *lines[1:]])
