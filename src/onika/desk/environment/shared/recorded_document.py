"""A recorded run as one document that a page plays without an environment (requirement X21, decision 63).

The document is packed by gzip: the length of its head (eight bytes, the lowest first), the head as JSON, then blocks of
numbers. What the head says is written in decision 63. Where it would become too large, instants lie further apart.
"""

import gzip
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import msgspec

from onika import __version__
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.shared.blocks import Blocks
from onika.desk.environment.shared.grid import grid
from onika.desk.environment.shared.history import history, states
from onika.desk.environment.shared.sight import sight
from onika.desk.environment.shared.variables import samples_of, variables
from onika.desk.environment.shared.worlds import worlds
from onika.record.downsampled import Samples
from onika.wire.view import Tree
from onika.words.homeless import homeless

PERIODS_S = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0)
"""Between two instants; the first with which the document is small enough."""
FORMAT = 1


@dataclass(frozen=True, slots=True)
class RecordedDocument:
    """The document, and how it was made."""

    content: bytes
    period_s: float
    """Between two instants at most."""
    instants: int
    fits: bool
    """Whether it is as small as was wanted."""


def recorded_document(
    subject: ReviewedRun, tree: Tree, most_bytes: int, meshes: Mapping[str, bytes] | None = None
) -> RecordedDocument:
    """The document of a recorded run that is looked at; raises what reading a recording raises."""
    samples = samples_of(subject)
    shown = sight(subject, tree)
    document = _made(subject, shown, samples, meshes or {}, PERIODS_S[0])
    lasts_s = subject.view.end_s - subject.view.begin_s
    for period_s in PERIODS_S[1:]:
        size = len(document.content)
        if size <= most_bytes or document.period_s > lasts_s:
            break
        if period_s < document.period_s * min(size / max(most_bytes, 1), 2.0):
            continue
        document = _made(subject, shown, samples, meshes or {}, period_s)
    return RecordedDocument(
        document.content, document.period_s, document.instants, fits=len(document.content) <= most_bytes
    )


def _made(
    subject: ReviewedRun, shown: Tree, samples: Mapping[str, Samples], meshes: Mapping[str, bytes], period_s: float
) -> RecordedDocument:
    instants, blocks = grid(subject.view, period_s), Blocks()
    head = {
        "format": FORMAT,
        "version": __version__,
        "period_s": period_s,
        "tree": shown,
        "instants": blocks.add(instants / 1e9, "f8"),
        "run": history(subject, instants),
        "states": states(subject, instants),
        "variables": variables(subject, samples, instants, blocks),
        "worlds": worlds(subject, instants, blocks),
        "meshes": {name: blocks.add_bytes(content) for name, content in meshes.items()},
        "blocks": blocks.places,
    }
    text = homeless(msgspec.json.encode(head).decode(), str(Path.home())).encode()
    whole = len(text).to_bytes(8, "little") + text + bytes(blocks.content)
    return RecordedDocument(gzip.compress(whole, 9, mtime=0), period_s, len(instants), fits=True)
