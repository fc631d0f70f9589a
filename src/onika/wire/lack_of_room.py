"""Tasks that found no gap between the cycles of their unit, as the outcome of a live edit tells them (law 21)."""

from onika.words.reason import Reason, every


def without_gap(cause: Reason) -> tuple[str, ...]:
    """The tasks of which a cause says so, by name."""
    of_tasks = [reason for reason in every(cause) if reason.key == "host.of_task"]
    return tuple(
        str(reason.args["task"]) for reason in of_tasks if any(inner.key == "runtime.no_gap" for inner in every(reason))
    )
