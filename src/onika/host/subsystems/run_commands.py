"""Run commands: what users want of running applications is taken to the flows it is meant for (E07, E08, E13, X03)."""

from collections.abc import Callable, Sequence

from msgspec import structs

from onika.host.run.application_run import ApplicationRun
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.wire import request, steer
from onika.words.condition import Condition
from onika.words.reason import NOTHING, Reason, reason_of

Answer = Callable[[request.Response], None]


class RunCommands:
    """Judges and passes on the steering messages for all applications of a runtime."""

    def __init__(self, subsystems: Subsystems) -> None:
        self._subsystems = subsystems

    def refusal(self, session: str, command: steer.Steering) -> Reason:
        """Why this session may not ask it; empty: it may. A run whose session is gone is everybody's."""
        run = self._run_meant(session, command)
        if isinstance(run, Reason):
            return run
        if run.session not in (session, ""):
            return Reason.of("host.begun_by", application=run.application, session=run.session)
        return NOTHING

    def carry_out(self, session: str, command: steer.Steering, now: int, answer: Answer) -> None:
        """Do it; answered once the engine has said that it does, or why not."""
        run = self._run_meant(session, command)
        if isinstance(run, Reason):
            answer(request.Refused(run))
            return
        names = (command.subsystem,) if command.subsystem else run.names
        if len(names) > 1 and not isinstance(command, steer.Pause | steer.Resume | steer.Step | steer.Recover):
            answer(request.Refused(Reason.of("host.one_flow", names=tuple(run.names))))
            return
        wrong = _wrong_condition(command)
        if wrong:
            answer(request.Refused(wrong))
            return
        waits = _Answers(len(names), answer)
        for name in names:
            run.runner.steer(structs.replace(command, subsystem=name), now, waits.take)

    def who(self, session: str) -> request.Response:
        """Where every flow is: of the asker's applications, of all where it has none."""
        own = [run for run in self._subsystems.runs if run.session == session]
        runs: Sequence[ApplicationRun] = own or self._subsystems.runs
        return steer.Positions(tuple(position for run in runs for position in run.runner.positions()))

    def _run_meant(self, session: str, command: steer.Steering) -> ApplicationRun | Reason:
        """The application that is meant, or why there is none."""
        if command.subsystem:
            named = self._subsystems.run_in(command.subsystem)
            if named is not None:
                return named
            return Reason.of("host.nothing_runs_in", subsystem=command.subsystem)
        runs = self._subsystems.runs
        candidates = [run for run in runs if run.session == session] or runs
        if len(candidates) == 1:
            return candidates[0]
        names = tuple(name for run in candidates for name in run.names)
        if candidates:
            return Reason.of("host.one_subsystem", names=names)
        return Reason.of("host.nothing_runs")


class _Answers:
    """One answer for several flows: refused where all of them refuse, for the first reason."""

    def __init__(self, count: int, answer: Answer) -> None:
        self._left = count
        self._refusals: list[Reason] = []
        self._is_done = False
        self._answer = answer

    def take(self, refusal: Reason) -> None:
        self._left -= 1
        self._is_done = self._is_done or not refusal
        self._refusals += [refusal] if refusal else []
        if not self._left:
            self._answer(request.Done() if self._is_done else request.Refused(self._refusals[0]))


def _wrong_condition(command: steer.Steering) -> Reason:
    if isinstance(command, steer.Mark) and command.condition:
        try:
            Condition.parse(command.condition)
        except ValueError as wrong:
            return reason_of(wrong)
    return NOTHING
