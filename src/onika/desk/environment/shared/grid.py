"""The instants of a recorded run that a shared file holds: so many in a second, and every instant that has a name.

Whoever plays the file goes from instant to instant, so that all that is shown of one is what was recorded for it.
"""

import numpy as np
from numpy.typing import NDArray

from onika.wire.view import RecordingView

Nanoseconds = NDArray[np.int64]


def grid(recording: RecordingView, period_s: float) -> Nanoseconds:
    """The instants in ns, rising: every `period_s` from the beginning on, those of actions and marks, and the end."""
    begin, end = _ns(recording.begin_s), _ns(max(recording.end_s, recording.begin_s))
    passages = [passage for flow in recording.flows.values() for passage in flow.passages]
    named = [_ns(passage.begin_s) for passage in passages]
    named += [_ns(passage.end_s) for passage in passages if passage.end_s is not None]
    named += [_ns(mark.at_s) for mark in recording.marks]
    regular = np.arange(begin, end, max(_ns(period_s), 1), dtype=np.int64)
    instants = np.concatenate([regular, np.array([*named, begin, end], dtype=np.int64)])
    return np.unique(instants[(instants >= begin) & (instants <= end)])


def _ns(seconds: float) -> int:
    return round(seconds * 1e9)
