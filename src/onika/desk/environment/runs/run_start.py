"""A run on its way: what is to be begun, and what there was to be seen before it (requirement E01)."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from onika.desk.environment.outcome.fault_view import FaultViews
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.messages import IconWording
from onika.desk.environment.run_state.puzzle_attempt import PuzzleAttempt
from onika.desk.environment.run_state.run import Run, begun
from onika.desk.environment.runs.unsaved import Changed
from onika.desk.environment.state.model import Model
from onika.model.puzzle import Puzzle
from onika.wire import act, request
from onika.wire.plan import Plan
from onika.wire.request import TargetValues
from onika.wire.view import Remedy
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class RunStart:
    """A run on its way: what is to be begun, and what there was to be seen before it."""

    command: act.Run
    name: str
    plan: Plan
    targets: tuple[TargetValues, ...]
    belonging: StepMembership
    wording: IconWording
    troubles: FaultViews
    durations: dict[tuple[int, int], float]
    notes: tuple[Reason, ...]
    began_at_s: float
    record: str = ""
    """The file of its recording; empty: none is made."""
    changed: tuple[Changed, ...] = ()
    """What it uses, or would take over, and is not saved; it is told with what is taken over."""
    unsaved: No | None = None
    """Why it does not run with that, where nothing is taken over."""
    stations: Mapping[str, str] = field(default_factory=dict)
    """Where its flows are carried out, by subsystem; empty: all at the station in focus."""
    together: tuple[Remedy, ...] = ()
    """Ways to have all of them at one, where they cannot meet."""

    puzzle: Puzzle | None = None
    """What it is to solve; None: nothing."""
    uncounted: Reason = NOTHING
    """Why the run does not count for that."""

    def run(self, model: Model) -> Run:
        """The run as it is shown before it has begun."""
        run = begun(self.command.doc, self.plan, model.performed + 1, self.began_at_s, self.belonging, self.wording)
        attempt = None if self.puzzle is None else PuzzleAttempt.of(self.puzzle, self.plan, self.uncounted)
        run = replace(run, durations=self.durations, station=model.station, attempt=attempt)
        run = run.shown(recording=self.record, station=model.station)
        for note in self.notes:
            run = run.noted(note)
        return run


def aborts(run: Run) -> tuple[request.Abort, ...]:
    """What ends a run: one wish at each station, which names a flow there."""
    firsts = [run.plan.flows[part.flows[0]].subsystem for part in run.parts] or [run.homes[0]]
    return tuple(request.Abort(Reason.of("desk.aborted_by_user"), home) for home in firsts)
