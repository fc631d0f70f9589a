"""The worlds of a recorded run at the instants of a shared file: where their bodies were, and what shone."""

from itertools import groupby
from typing import Any

import numpy as np

from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.shared.blocks import Blocks
from onika.desk.environment.shared.grid import Nanoseconds
from onika.desk.run.run_review import Review


def worlds(subject: ReviewedRun, instants: Nanoseconds, blocks: Blocks) -> dict[str, Any]:
    """What a shared file says of each world; poses go into `blocks`."""
    return {world: _world(subject.review, world, instants, blocks) for world in subject.review.worlds}


def _world(review: Review, world: str, instants: Nanoseconds, blocks: Blocks) -> dict[str, Any]:
    stretches = []
    frames = [review.poses(world, at * 1e-9) or review.first_poses(world) for at in instants.tolist()]
    numbered = list(enumerate(frames))
    for count, group in groupby(numbered, key=lambda entry: len(entry[1])):
        entries = list(group)
        if count:
            rows = np.array([row for _, row in entries], dtype=np.float64).reshape(len(entries), -1)
            block = blocks.add(rows.T, "f4")
            stretches.append({"first": entries[0][0], "poses": block})
    lit: list[tuple[int, list[str]]] = []
    for place, at in enumerate(instants.tolist()):
        shining = review.lit(world, at * 1e-9)
        if not lit or lit[-1][1] != shining:
            lit.append((place, shining))
    return {"shapes": review.shapes(world, float(instants[0]) * 1e-9) or [], "stretches": stretches, "lit": lit}
