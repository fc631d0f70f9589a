"""Failed writers: a device is not driven again while a task that feeds it is still in ERROR (law 4, decision 41).

What such a task wrote last stands in its variables, and tasks between go on making fresh values of it: that all inputs
of the device were written anew says nothing then.
"""

from collections.abc import Collection, Mapping

from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.words.reason import NOTHING, Reason


def objection_to_clear(live: LiveSubsystem, task: str) -> Reason:
    """Why a task stays in ERROR for now; empty: it may be cleared.

    Only tasks without a device of their own are in its way, which can always be cleared: nobody waits for each other.
    """
    subsystem = live.executor.subsystem
    writers = [
        failed
        for failed in sorted(live.executor.failed_at_work)
        if not subsystem.is_hardware(failed) and task in subsystem.fed(failed, live.members)
    ]
    if not writers:
        return NOTHING
    return Reason.of("host.clear_writers_first", task=task, writers=tuple(writers))


def objections_to_switch(live: LiveSubsystem, off: Collection[str], on: Collection[str]) -> Mapping[str, Reason]:
    """Who may not come on, as a device would be driven then with what a failed task wrote; whoever names it in `off`
    wants it so."""
    subsystem = live.executor.subsystem
    staying = {task for task in live.members if live.is_on(task)} - {*off}
    objections: dict[str, Reason] = {}
    for failed in sorted(live.executor.failed_at_work - {*off}):
        for driven in subsystem.fed(failed, staying | {*on}):
            coming = [driven] if driven in on else on
            reason = Reason.of("host.fed_by_failed", driven=driven, writer=failed)
            objections.update(dict.fromkeys(coming, reason))
    return objections
