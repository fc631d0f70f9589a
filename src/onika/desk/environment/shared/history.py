"""What was shown of a recorded run at the instants of a shared file: the first time whole, then what changed."""

from bisect import bisect_right
from itertools import accumulate
from typing import Any

import msgspec
from msgspec import structs

from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.shared.grid import Nanoseconds
from onika.desk.environment.show.tree_difference import difference
from onika.wire import event
from onika.wire.view import RunView


def history(subject: ReviewedRun, instants: Nanoseconds) -> dict[str, Any]:
    """`first`, and `changes`: at which instant, at which places, what stands there from then on (null: nothing)."""
    times = list(accumulate((at for at, _, _ in subject.review.events), max))
    last_count, shown = -1, _bare(subject.replay.at(-1e9))
    first, changes = shown, []
    for place, at in enumerate(instants.tolist()):
        count = bisect_right(times, at)
        if count == last_count:
            continue
        last_count, now = count, _bare(subject.replay.at(at * 1e-9))
        if parts := difference(shown, now):
            changes.append((place, parts))
        shown = now
    return {"first": msgspec.to_builtins(first), "changes": changes}


def states(subject: ReviewedRun, instants: Nanoseconds) -> list[tuple[int, dict[str, str]]]:
    """At which instants which tasks, by `SUBSYSTEM/TASK`, came into which states."""
    stand_ins: dict[str, list[str]] = {}
    for flow in subject.review.run.prepare.plan.flows:
        for name, old in flow.replaced:
            stand_ins.setdefault(f"{flow.subsystem}/{name}", []).append(f"{flow.subsystem}/{old.name}")
    changes: dict[int, dict[str, str]] = {}
    ends = instants.tolist()
    for at, _, message in subject.review.events:
        if isinstance(message, event.TaskState):
            address = f"{message.subsystem}/{message.task}"
            place = bisect_right(ends, at - 1)
            if place < len(ends):
                turned = dict.fromkeys((address, *stand_ins.get(address, ())), message.state)
                changes.setdefault(place, {}).update(turned)
    return sorted(changes.items())


def _bare(run: RunView) -> RunView:
    """Without what is of use on the machine only where it was recorded."""
    stops = {key: structs.replace(stop, path="", black_box="") for key, stop in run.stops.items()}
    return structs.replace(run, recording="", black_box="", stops=stops)
