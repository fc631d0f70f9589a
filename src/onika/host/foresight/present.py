"""The present situation of a runtime, as it stands when somebody asks what would follow from a fault."""

from collections.abc import Callable, Iterable, Iterator, Mapping

from onika.host.foresight.situation import ForeseenTask, RunFacts, SessionFacts, Situation, looked_at
from onika.host.run.application_run import ApplicationRun
from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.ring.drive import DriveMode
from onika.runtime.subsystem import Member


def present(
    subsystems: Subsystems,
    modes: Mapping[str, DriveMode],
    sessions: Mapping[str, SessionFacts],
    records: str,
) -> Situation:
    """Everything that decides, in one value."""
    tasks = [*_of_runs(subsystems.runs), *_by_hand(subsystems.live.values())]
    return Situation(
        tasks={facts.address: facts for facts in tasks},
        modes=modes,
        runs=tuple(_run(run) for run in subsystems.runs if not run.runner.is_over),
        holders={name: live.holder for name, live in subsystems.live.items()},
        sessions=sessions,
        records=records,
    )


def _run(run: ApplicationRun) -> RunFacts:
    return RunFacts(run.application, run.session, run.on_loss, run.flows, run.runner.engine)


def _of_runs(runs: Iterable[ApplicationRun]) -> Iterator[ForeseenTask]:
    for run in runs:
        for name in run.names:
            yield from _tasks(name, run.members(name), run.source)


def _by_hand(subsystems: Iterable[LiveSubsystem]) -> Iterator[ForeseenTask]:
    for live in subsystems:
        for facts in _tasks(live.name, live.members, live.executor.source):
            rate = live.desired.rate(facts.wired.name)
            yield facts if rate is None else facts.at(rate)


def _tasks(subsystem: str, members: Mapping[str, Member], source: Callable[[str], str]) -> Iterator[ForeseenTask]:
    for member in members.values():
        if member.is_sent:
            task = member.wired.task
            looks_at = looked_at(source(task.digest))
            yield ForeseenTask(subsystem, member.wired, member.state, member.rtpu, task.frequency, looks_at)
